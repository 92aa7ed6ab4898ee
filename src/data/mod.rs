//! `Serialize` and `Deserialize` of what constructors check (feature `serde`).
//!
//! Layer 6. Structures whose fields are public derive both where they are defined. The types here
//! have invariants, so they go through their constructors on the way in: a file with `alpha = -1`
//! is refused with the constructor's message. No format is chosen: numbers are numbers, fields
//! have the names of constructors' arguments, and unknown fields are refused. Values return to the
//! bit where the format's reader rounds decimals correctly (of serde_json: with its feature
//! `float_roundtrip`).

/// Writes both traits of a type by a structure of its fields: what each is read from, and what the
/// type is made of.
macro_rules! data {
    ($name:literal, $type:ty $(, $extra:ident)? {
        $($(#[$attribute:meta])* $field:ident: $of:ty = $read:expr),* $(,)?
    } |$value:ident| => $make:expr) => {
        const _: () = {
            use crate::scalar::Real;
            use ::serde::{Deserialize, Deserializer, Serialize, Serializer, de};

            #[derive(Serialize, Deserialize)]
            #[serde(rename = $name, deny_unknown_fields)]
            #[serde(bound(serialize = "R: Real + Serialize"))]
            #[serde(bound(deserialize = "R: Real + Deserialize<'de>"))]
            struct Data<R> {
                $($(#[$attribute])* $field: $of,)*
            }

            impl<$($extra: crate::ndf::Distribution,)? R: Real + Serialize> Serialize for $type {
                fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                    let $value = self;
                    Data::<R> { $($field: $read,)* }.serialize(serializer)
                }
            }

            impl<'de, $($extra: crate::ndf::Distribution,)? R: Real + Deserialize<'de>>
                Deserialize<'de> for $type
            {
                fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                    let Data { $($field,)* } = Data::<R>::deserialize(deserializer)?;
                    let made: Result<Self, crate::error::Error> = $make;
                    made.map_err(de::Error::custom)
                }
            }
        };
    };
}

mod filter;
mod material;
mod shade;
mod slope;
