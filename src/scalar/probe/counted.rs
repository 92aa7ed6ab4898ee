//! A number that counts what is done with it: what a formula costs, whatever the machine.
//!
//! Layer 0, feature `probe`. An f32 in all its results; every operation is noted for the thread
//! that does it.

use crate::scalar::{Internal, Real};
use core::cell::Cell;
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// How often each kind of operation was done.
///
/// Signs, halves of a significand and constants are free. A transcendental function counts as one,
/// whatever its polynomial. Comparisons include those of minima, maxima and selects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: u64,
    /// Multiplications.
    pub multiplications: u64,
    /// Divisions.
    pub divisions: u64,
    /// Square roots.
    pub roots: u64,
    /// exp, ln, arctangents, error functions, sine and cosine.
    pub transcendental: u64,
    /// Comparisons.
    pub comparisons: u64,
}

std::thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        roots: 0,
        transcendental: 0,
        comparisons: 0,
    }) };
}

/// What `f` returns, and the operations on [`Counted`] numbers that it did on this thread.
///
/// ```
/// use lobe::probe::{Counted, operations_of};
/// use lobe::{Ggx, Isotropic, Real};
/// let ggx = Ggx::new(Isotropic::new(Counted::lit(0.1))?);
/// let slope = [Counted::lit(0.05), Counted::lit(0.0)];
/// let (pdf, operations) = operations_of(|| ggx.slope_pdf(slope));
/// assert_eq!(pdf.to_f64() as f32, Ggx::new(Isotropic::new(0.1_f32)?).slope_pdf([0.05, 0.0]));
/// assert_eq!((operations.divisions, operations.transcendental), (1, 0));
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn operations_of<T>(f: impl FnOnce() -> T) -> (T, Operations) {
    let outer = DONE.replace(Operations::default());
    let result = f();
    (result, DONE.replace(outer))
}

/// Notes one operation.
fn note(kind: fn(&mut Operations) -> &mut u64) {
    let mut done = DONE.get();
    *kind(&mut done) += 1;
    DONE.set(done);
}

/// An f32 that counts. Another precision of [`Real`]: everything in this crate runs on it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counted(f32);

impl fmt::Display for Counted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        note(|done| &mut done.comparisons);
        self.0 == other.0
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        note(|done| &mut done.comparisons);
        self.0.partial_cmp(&other.0)
    }
}

macro_rules! binary {
    ($trait:ident, $function:ident, $kind:ident) => {
        impl $trait for Counted {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                note(|done| &mut done.$kind);
                Self($trait::$function(self.0, other.0))
            }
        }
    };
}

binary!(Add, add, additions);
binary!(Sub, sub, additions);
binary!(Mul, mul, multiplications);
binary!(Div, div, divisions);

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

macro_rules! functions {
    ($($function:ident $kind:ident),*) => {
        $(fn $function(self) -> Self {
            note(|done| &mut done.$kind);
            Self(Real::$function(self.0))
        })*
    };
}

impl Internal for Counted {
    const SINGLE: bool = true;

    fn upper_angle(self, x: Self) -> Self {
        note(|done| &mut done.transcendental);
        Self(self.0.upper_angle(x.0))
    }
    fn exp2_of_negative(self) -> Self {
        note(|done| &mut done.transcendental);
        Self(self.0.exp2_of_negative())
    }
    fn product_or_zero(self, other: Self) -> Self {
        note(|done| &mut done.comparisons);
        note(|done| &mut done.multiplications);
        Self(self.0.product_or_zero(other.0))
    }
    fn exponent(self) -> i32 {
        self.0.exponent()
    }
    fn upper_half(self) -> Self {
        Self(self.0.upper_half())
    }
    fn atan_excess(self) -> Self {
        note(|done| &mut done.transcendental);
        Self(self.0.atan_excess())
    }
}

impl Real for Counted {
    const ZERO: Self = Self(0.0);
    const HALF: Self = Self(0.5);
    const ONE: Self = Self(1.0);
    const TWO: Self = Self(2.0);
    const PI: Self = Self(f32::PI);
    const EPSILON: Self = Self(f32::EPSILON);
    const MIN_POSITIVE: Self = Self(f32::MIN_POSITIVE);
    const MAX: Self = Self(f32::MAX);
    const LARGEST: Self = Self(f32::LARGEST);

    fn lit(x: f64) -> Self {
        Self(Real::lit(x))
    }
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn sin_cos(self) -> (Self, Self) {
        note(|done| &mut done.transcendental);
        note(|done| &mut done.transcendental);
        let (sin, cos) = Real::sin_cos(self.0);
        (Self(sin), Self(cos))
    }
    functions!(
        sqrt roots, exp transcendental, ln transcendental, atan transcendental, erfc transcendental,
        erfcx transcendental, ierfcx transcendental, ierfc_excess transcendental
    );
    fn atan2(self, x: Self) -> Self {
        note(|done| &mut done.transcendental);
        Self(Real::atan2(self.0, x.0))
    }
}
