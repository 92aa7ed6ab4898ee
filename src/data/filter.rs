//! Kernels, pixel filters and lights.
//!
//! Layer 6.

use crate::filter::{DiskKernel, Kernel, PixelFilter, SphericalGaussian};
use crate::scalar::Psd;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

data!("Kernel", Kernel<R> {
    covariance: Psd<R> = kernel.covariance(),
} |kernel| => Ok(Self::from_covariance(covariance)));

data!("DiskKernel", DiskKernel<R> {
    covariance: Psd<R> = kernel.covariance(),
} |kernel| => Ok(Self::from_covariance(covariance)));

data!("SphericalGaussian", SphericalGaussian<R> {
    direction: [R; 3] = light.direction(),
    sharpness: R = light.sharpness(),
} |light| => Self::restored(direction, sharpness));

/// A pixel filter is its variance, a number.
impl Serialize for PixelFilter {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.variance().serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for PixelFilter {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::with_variance(f64::deserialize(deserializer)?).map_err(de::Error::custom)
    }
}
