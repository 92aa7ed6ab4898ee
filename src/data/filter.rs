//! Kernels, pixel filters and lights.
//!
//! Layer 6.

use crate::error::Error;
use crate::filter::{DiskKernel, Kernel, PixelFilter, SphericalGaussian};
use crate::scalar::Psd;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

data!("Kernel", Kernel<R> {
    #[serde(skip_serializing_if = "Option::is_none")]
    covariance: Option<Psd<R>> = None,
    #[serde(skip_serializing_if = "Option::is_none")]
    columns: Option<[[R; 2]; 2]> = Some(kernel.columns()),
} |kernel| => match (covariance, columns) {
    (None, Some([u, v])) => Self::from_columns(u, v),
    (Some(covariance), None) => Ok(Self::from_covariance(covariance)),
    _ => Err(Error::KernelGiven),
});

data!("DiskKernel", DiskKernel<R> {
    as_slopes: Kernel<R> = kernel.as_slopes(),
} |kernel| => Ok(Self::from_kernel(as_slopes)));

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
