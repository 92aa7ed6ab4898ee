//! How the table of items becomes code.
//!
//! Layer 0.

/// Expands the table: the enum, its list, the entries, and the names behind features that are off.
macro_rules! items {
    (
        $($variant:ident: $kind:tt $name:literal $(, $twin:literal)?;)*
        $(
            #[feature($feature:literal)]
            $($gated:ident: $gated_kind:tt $gated_name:literal $(, $gated_twin:literal)?;)*
        )*
    ) => {
        /// A function or constant of the WGSL port, or a whole file of it, to ask
        /// [`source`](super::source) for.
        ///
        /// A file stands for all that it declares. Structures come with what uses them.
        ///
        /// ```
        /// use lobe::wgsl::Item;
        /// assert!(Item::ALL.iter().all(|item| Item::from_name(item.name()) == Ok(*item)));
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Item {
            $(
                #[doc = concat!(
                    "The ", word!($kind), " `", $name, "`" $(, ", twin of `", $twin, "`")?, "."
                )]
                $variant,
            )*
            $($(
                #[cfg(feature = $feature)]
                #[doc = concat!("The ", word!($gated_kind), " `", $gated_name, "`" $(, ", twin of \
                    `", $gated_twin, "`")?, ".")]
                $gated,
            )*)*
        }

        impl Item {
            /// Every item, in the order of the files; those of features last.
            pub const ALL: &'static [Self] = &[
                $(Self::$variant,)*
                $($(#[cfg(feature = $feature)] Self::$gated,)*)*
            ];

            /// Kind, name and twin; no twin is an empty one.
            pub(super) const fn entry(self) -> (Kind, &'static str, &'static str) {
                match self {
                    $(Self::$variant => (kind!($kind), $name, concat!($($twin)?)),)*
                    $($(
                        #[cfg(feature = $feature)]
                        Self::$gated => (kind!($gated_kind), $gated_name, concat!($($gated_twin)?)),
                    )*)*
                }
            }
        }

        /// Names behind features that are off, and the feature.
        pub(super) const OFF: &[(&str, &str)] = &[
            $($(#[cfg(not(feature = $feature))] ($gated_name, $feature),)*)*
        ];
    };
}

/// What an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Function,
    Constant,
    File,
}

/// The noun of a keyword.
macro_rules! word {
    (fn) => {
        "function"
    };
    (const) => {
        "constant"
    };
    (file) => {
        "file"
    };
}

/// The kind of a keyword.
macro_rules! kind {
    (fn) => {
        Kind::Function
    };
    (const) => {
        Kind::Constant
    };
    (file) => {
        Kind::File
    };
}

pub(super) use {items, kind, word};
