//! Why a constructor refused its arguments.
//!
//! Layer 0: imports nothing. The hot path has no errors: only constructors return them.

use core::fmt;

/// The number that a constructor refused.
///
/// Two values are equal if their bits are, so that NaN equals itself. [`Display`](fmt::Display)
/// writes the shortest decimals that give the number back: those of an f32 if it is one.
///
/// ```
/// use lobe::Value;
/// assert_eq!(Value::from(0.1_f32).to_string(), "0.1");
/// assert_eq!(Value::from(f64::NAN), Value::from(f64::NAN));
/// assert_eq!(Value::from(-2e9_f32).get(), -2e9);
/// ```
#[derive(Clone, Copy)]
pub struct Value(f64);

impl Value {
    pub(crate) const fn new(value: f64) -> Self {
        Self(value)
    }

    /// The number, as f64.
    pub const fn get(self) -> f64 {
        self.0
    }
}

impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        self.0.to_bits() == other.0.to_bits() || self.0.is_nan() && other.0.is_nan()
    }
}

impl Eq for Value {}

impl core::hash::Hash for Value {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        // One pattern for all that is NaN, as they are equal.
        let bits = if self.0.is_nan() { u64::MAX } else { self.0.to_bits() };
        bits.hash(state);
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let single = self.0 as f32;
        let plain = self.0 == 0.0 || (1e-5..1e7).contains(&self.0.abs()) || !self.0.is_finite();
        match (f64::from(single) == self.0, plain) {
            (true, true) => write!(f, "{single}"),
            (true, false) => write!(f, "{single:e}"),
            (false, true) => write!(f, "{}", self.0),
            (false, false) => write!(f, "{:e}", self.0),
        }
    }
}

impl fmt::Debug for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The enum, and what it says of numbers that lie outside of their range.
macro_rules! errors {
    (
        numbers: { $($number:ident $name:literal $range:literal;)* }
        others: {
            $(
                $(#[$doc:meta])*
                $other:ident $(($($field:ty),*))? $({ $($named:ident: $of:ty),* })?,
            )*
        }
    ) => {
        /// What a constructor refused: the parameter, the value, and why.
        ///
        /// The message names the parameter and shows its value and range.
        ///
        /// ```
        /// use lobe::{Error, Roughness};
        /// let error = Roughness::from_alpha(-1.0_f32).unwrap_err();
        /// assert_eq!(error, Error::Alpha((-1.0_f32).into()));
        /// assert_eq!(error.to_string(), "alpha = -1 is not in [0, 1e9]");
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Error {
            $(
                #[doc = concat!("`", $name, "` is not in `", $range, "`.")]
                $number(Value),
            )*
            $(
                $(#[$doc])*
                $other $(($($field),*))? $({ $(
                    #[doc = concat!("`", stringify!($named), "`.")]
                    $named: $of
                ),* })?,
            )*
        }

        impl Error {
            /// Name, value and range of a number that is outside of it.
            const fn number(&self) -> Option<(&'static str, Value, &'static str)> {
                match *self {
                    $(Self::$number(value) => Some(($name, value, $range)),)*
                    _ => None,
                }
            }
        }
    };
}

errors! {
    numbers: {
        Alpha "alpha" "[0, 1e9]";
        AlphaX "alpha_x" "[0, 1e9]";
        AlphaY "alpha_y" "[0, 1e9]";
        Angle "angle" "(-inf, inf)";
        Perceptual "perceptual" "[0, 1]";
        SigmaX "sigma_x" "[0, 1e9]";
        SigmaY "sigma_y" "[0, 1e9]";
        Sigma "sigma" "[0, 1e9]";
        Width "width" "[0, 1e9]";
        Sharpness "sharpness" "[1e-9, 1e18]";
        Radius "radius" "[2e-9, 6e4]";
        Rho "rho" "[-1, 1]";
        MatrixEntry "matrix entry" "[-1e18, 1e18]";
        Mean "mean" "[-1e9, 1e9]";
        Variance "variance" "[0, 1e9]";
        Added "added" "[0, 1e9]";
        Limit "limit" "[0, inf]";
        Weight "weight" "[0, inf)";
        WeightSum "sum of weights" "(0, inf)";
        Reflectance "reflectance at normal incidence" "[0, 1]";
        Eta "eta" "(0, 1e9]";
        K "k" "[0, 1e9]";
        Cap "steepest" "(0, 1e9]";
        Texel "texel" "[1e-9, 1e9], of either sign";
        Displacement "displacement" "[-1e9, 1e9]";
        MeanLength "length" "(0, 1 + sqrt(3)/254]";
        Exponent "exponent" "[0, 1e9]";
        Spacing "spacing" "(0, 10]";
        Range "range" "(1e-9, 1e9]";
        HalfRange "range of halves" "(1e-9, 255]";
        Fraction "fraction" "(0, 1]";
        Density "density" "[1e-18, 1e18]";
        Variation "variation" "[0, 4]";
        Share "share" "[0, 1]";
        Facets "density" "[1e-18, 1e30]";
    }
    others: {
        /// The matrix of the entries xx, xy and yy has a negative eigenvalue.
        MatrixNotPositive([Value; 3]),
        /// These numbers, l_xx, l_yx and l_yy, are no Cholesky factor in range.
        Factor([Value; 3]),
        /// A matrix in a file has both entries and a Cholesky factor, or neither.
        MatrixGiven,
        /// A kernel in a file has both a covariance and columns, or neither.
        KernelGiven,
        /// A kernel's column has a component that is not in [-1e9, 1e9].
        Column([Value; 2]),
        /// A material's data are of another distribution than the one of this name.
        Distribution { expected: &'static str },
        /// Slices that belong together differ in length.
        Length { expected: usize, found: usize },
        /// A half vector is not finite or does not point above the surface, so it has no slope.
        HalfVector([Value; 3]),
        /// A derivative of the half vector's slope is not finite.
        Derivative([Value; 2]),
        /// The average of the normals of a quad is not finite, or not above all of its surfaces.
        QuadNormal([Value; 3]),
        /// A position or direction has no length, or is infinite or NaN.
        Direction([Value; 3]),
        /// A map's size and the number of its texels differ, or it has none.
        MapSize { size: [usize; 2], texels: usize },
        /// The side of a cube map's faces is no power of two, or its texels are not those of all
        /// levels.
        CubeMap { face: usize, texels: usize },
        /// A quadrature has no node.
        NoNode,
        /// The number of a recipe's marginals is not in [1, 65536].
        Marginals(u32),
        /// The number of a recipe's levels is not in [1, 20].
        Levels(u32),
        /// The number of a recipe's intervals is not a power of two in [8, 4096].
        Intervals(u32),
        /// The width of a recipe's lobes is not in [2/`intervals`, 0.5].
        LobeWidth { width: Value, intervals: u32 },
        /// No rule for the means of lobes has this number.
        LobeMeans(u32),
        /// Bytes are not a dictionary's.
        DictionaryMagic,
        /// Bytes are a dictionary's, of another version of the layout.
        DictionaryVersion(u32),
        /// Bytes of a dictionary are fewer or more than its header says.
        DictionaryLength { expected: usize, found: usize },
        /// Bytes of a dictionary are damaged.
        DictionaryChecksum { expected: u32, found: u32 },
        /// Bytes of a dictionary are undamaged, and a table of them is no density with an integral
        /// of 1.
        DictionaryDensity { table: usize },
    }
}

/// Refuses a slice whose length is not that of the slice beside it.
#[inline]
pub(crate) const fn same_length(expected: usize, found: usize) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::Length { expected, found }) }
}

/// Numbers in parentheses.
struct Tuple<'a>(&'a [Value]);

impl fmt::Display for Tuple<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, value) in self.0.iter().enumerate() {
            write!(f, "{}{value}", if k == 0 { "(" } else { ", " })?;
        }
        f.write_str(")")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((name, value, range)) = self.number() {
            return write!(f, "{name} = {value} is not in {range}");
        }
        match self {
            Self::MatrixNotPositive([xx, xy, yy]) => {
                write!(f, "matrix [[{xx}, {xy}], [{xy}, {yy}]] is not positive semi-definite")
            }
            Self::MatrixGiven => {
                write!(f, "a matrix takes one of the fields `entries` and `cholesky`")
            }
            Self::KernelGiven => {
                write!(f, "a kernel takes one of the fields `covariance` and `columns`")
            }
            Self::Column([x, y]) => write!(f, "column ({x}, {y}) is not in [-1e9, 1e9]"),
            Self::Factor([l_xx, l_yx, l_yy]) => {
                write!(f, "[[{l_xx}, 0], [{l_yx}, {l_yy}]] is not a Cholesky factor in range")
            }
            Self::Distribution { expected } => write!(f, "distribution is not {expected}"),
            Self::Length { expected, found } => {
                write!(f, "slices differ in length: {found} is not {expected}")
            }
            Self::HalfVector(h) => {
                write!(f, "half vector {} is not finite, or not above the surface", Tuple(h))
            }
            Self::Derivative(d) => {
                write!(f, "derivative {} of the half vector's slope is not finite", Tuple(d))
            }
            Self::QuadNormal(n) => {
                write!(f, "average normal {} of a quad is not above its surfaces", Tuple(n))
            }
            Self::Direction(w) => {
                write!(f, "direction or position {} is not finite, or has no length", Tuple(w))
            }
            Self::MapSize { size: [width, height], texels } => {
                write!(f, "a map of {width} x {height} texels cannot have {texels}")
            }
            Self::CubeMap { face, texels } => {
                write!(
                    f,
                    "a cube map of faces {face} wide, a power of two, cannot have {texels} texels"
                )
            }
            Self::NoNode => f.write_str("a quadrature of 0 nodes has no sum"),
            Self::Marginals(n) => write!(f, "marginals = {n} is not in [1, 65536]"),
            Self::Levels(n) => write!(f, "levels = {n} is not in [1, 20]"),
            Self::Intervals(n) => write!(f, "intervals = {n} is not a power of two in [8, 4096]"),
            Self::LobeWidth { width, intervals } => {
                write!(f, "width = {width} is not in [2/{intervals}, 0.5]")
            }
            Self::LobeMeans(n) => write!(f, "means = {n} is not in [0, 1]"),
            Self::DictionaryMagic => f.write_str("bytes do not begin as a dictionary's"),
            Self::DictionaryVersion(n) => {
                write!(f, "version = {n} of a dictionary's bytes is not 1")
            }
            Self::DictionaryLength { expected, found } => {
                write!(f, "a dictionary's {found} bytes are not the {expected} of its header")
            }
            Self::DictionaryChecksum { expected, found } => write!(
                f,
                "a dictionary's bytes are damaged: their checksum {found:#010x} is not \
                    {expected:#010x}"
            ),
            Self::DictionaryDensity { table } => {
                write!(
                    f,
                    "table {table} of a dictionary's bytes is no density with an integral of 1"
                )
            }
            _ => Ok(()),
        }
    }
}

impl core::error::Error for Error {}
