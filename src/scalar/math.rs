//! The three functions that come from outside: sqrt, sin and cos, by std or by libm.
//!
//! Layer 0. Everything else is our own polynomial, so that builds with and without std compute the
//! same bits (sqrt is correctly rounded everywhere; sin and cos serve constructors only).

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("lobe needs one of the features `std` (the default) and `libm`");

#[cfg(feature = "std")]
mod backend {
    #[inline(always)]
    pub(super) fn sqrt_f32(x: f32) -> f32 {
        x.sqrt()
    }
    #[inline(always)]
    pub(super) fn sqrt_f64(x: f64) -> f64 {
        x.sqrt()
    }
    #[inline(always)]
    pub(super) fn sin_cos(x: f64) -> (f64, f64) {
        x.sin_cos()
    }
}

#[cfg(all(feature = "libm", not(feature = "std")))]
mod backend {
    #[inline(always)]
    pub(super) fn sqrt_f32(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    #[inline(always)]
    pub(super) fn sqrt_f64(x: f64) -> f64 {
        libm::sqrt(x)
    }
    #[inline(always)]
    pub(super) fn sin_cos(x: f64) -> (f64, f64) {
        libm::sincos(x)
    }
}

#[cfg(not(any(feature = "std", feature = "libm")))]
mod backend {
    #[inline(always)]
    pub(super) fn sqrt_f32(x: f32) -> f32 {
        x
    }
    #[inline(always)]
    pub(super) fn sqrt_f64(x: f64) -> f64 {
        x
    }
    #[inline(always)]
    pub(super) fn sin_cos(x: f64) -> (f64, f64) {
        (x, x)
    }
}

#[inline(always)]
pub(super) fn sqrt_f32(x: f32) -> f32 {
    backend::sqrt_f32(x)
}

#[inline(always)]
pub(super) fn sqrt_f64(x: f64) -> f64 {
    backend::sqrt_f64(x)
}

/// Sine and cosine in f64 for both precisions: constructors call it once, and need it exact.
#[inline]
pub(super) fn sin_cos(x: f64) -> (f64, f64) {
    backend::sin_cos(x)
}
