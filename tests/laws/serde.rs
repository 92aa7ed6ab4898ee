//! What is written is read again to the bit, and what constructors refuse is refused by name.
#![cfg(feature = "serde")]

use crate::common::check;
use core::fmt::Debug;
use lobe::filter::{DiskKernel, SphericalGaussian};
use lobe::material::Fresnel;
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, Glints};
use lobe::material::lean::{Border, SlopeCap};
use lobe::material::multilobe::{LobeMeans, MultiLobe, Recipe};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::shade::{GlintMaterial, Material, MultiLobeMaterial};
use lobe::slope::Motion;
use lobe::{
    AxisAligned, Footprint, Isotropic, Kernel, Lobe, Path, PixelFilter, Psd, Real, Roughness,
    SlopeMoments, Vertex,
};
use proptest::test_runner::{TestCaseError, TestCaseResult};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// The value after a way through JSON.
fn back<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: &T) -> TestCaseResult {
    let text = serde_json::to_string(value).expect("numbers that JSON has");
    let read: T = serde_json::from_str(&text)
        .map_err(|error| TestCaseError::fail(format!("{text}: {error}")))?;
    if read == *value { Ok(()) } else { Err(TestCaseError::fail(format!("{text}: {read:?}"))) }
}

fn there_and_back<R: Real + Serialize + DeserializeOwned>() {
    check(2_000, |source| {
        let alphas: [R; 9] = [(); 9].map(|()| R::lit(source.log_uniform(1e-4, 30.0)));
        let mut drawn = alphas.into_iter();
        let mut alpha = || drawn.next().expect("as many as are asked for");
        let roughness = Roughness::from_alphas(alpha(), alpha(), alpha()).expect("in range");
        let (mean, u, v) = ([alpha(), -alpha()], [alpha(), alpha()], [-alpha(), alpha()]);
        let footprint = Footprint::from_slopes(u, v);
        let kernel = Kernel::of(&footprint, PixelFilter::BOX);
        back(&roughness)?;
        back(&roughness.matrix())?;
        // Nearly parallel sides carry a determinant that is all rounding of the entries.
        let nearly = R::lit(source.log_uniform(1e-9, 1e-3));
        let thin = Footprint::from_slopes(u, [u[0] * (R::ONE + nearly), u[1]]);
        let thin = Kernel::of(&thin, PixelFilter::BOX);
        back(&thin)?;
        back(&(thin + kernel))?;
        back(&(thin.covariance() + roughness.matrix() * nearly))?;
        back(&(roughness.matrix() * R::lit(1e-30)))?;
        back(&kernel)?;
        back(&footprint)?;
        back(&roughness.widened(&kernel))?;
        back(&DiskKernel::of(u, v, PixelFilter::KAPLANYAN))?;
        back(&SlopeMoments::new(mean, kernel.covariance()).expect("in range"))?;
        back(&Lobe::new(mean, roughness).expect("in range"))?;
        back(&roughness.alphas())?;
        back(&Isotropic::new(u[0]).expect("in range"))?;
        back(&AxisAligned::new(u[0], u[1]).expect("in range"))?;
        back(&Patch::new(mean, u, v))?;
        back(&Motion { half_vector: [u[0], v[0], u[1]], normal: v, spin: u[0] })?;
        let vertex = Vertex::at([u[0], v[0], u[1]]).expect("a length");
        back(&SphericalGaussian::new(vertex.direction, u[0]).expect("in range"))?;
        back(&Path { eye: vertex, light: vertex, curvature: [u[0], v[0], u[1]] })
    });
    let one = R::ONE;
    let roughness = Roughness::from_alpha(R::lit(0.1)).expect("in range");
    let biscale = Biscale::new(roughness, roughness);
    let glints = Glints::new(biscale, R::lit(1e5)).and_then(|glints| glints.with_variation(one));
    let glints = glints.and_then(|glints| glints.with_share(R::HALF)).expect("in range");
    let facets = MultiLobe::new(roughness, R::lit(1e5)).expect("in range").with_seed(7);
    let fresnel = Fresnel::conductor([one; 3], [R::TWO; 3]).expect("in range");
    let schlick = Fresnel::schlick([R::HALF; 3]).expect("in range");
    back(&fresnel).expect("back");
    back(&Material::ggx(Lobe::centered(roughness), schlick)).expect("back");
    back(&GlintMaterial { glints: glints.with_seed(3), fresnel }).expect("back");
    back(&MultiLobeMaterial { facets, fresnel: schlick }).expect("back");
    back(&SlopeCap::new(one).expect("in range")).expect("back");
}

#[test]
fn what_is_written_is_read_again_in_single_precision() {
    there_and_back::<f32>();
}

#[test]
fn what_is_written_is_read_again_in_double_precision() {
    there_and_back::<f64>();
    back(&PixelFilter::TOKUYOSHI_KAPLANYAN).expect("back");
    back(&Recipe { means: LobeMeans::Chermain, ..Recipe::default() }).expect("back");
    back(&Border::Clamp).expect("back");
}

#[test]
fn what_constructors_refuse_is_refused_by_name() {
    fn refused<T: DeserializeOwned + Debug>(text: &str, message: &str) {
        let error = serde_json::from_str::<T>(text).expect_err("out of range").to_string();
        assert!(error.starts_with(message), "{text}: {error}");
    }
    refused::<Isotropic<f32>>(r#"{"alpha": -1}"#, "alpha = -1 is not in [0, 1e9]");
    refused::<PixelFilter>("-0.5", "variance = -0.5 is not in [0, 1e9]");
    let indefinite = r#"{"entries": [1, 2, 1]}"#;
    refused::<Psd<f64>>(indefinite, "matrix [[1, 2], [2, 1]] is not positive semi-definite");
    let negative = r#"{"cholesky": [1, 2, -1]}"#;
    refused::<Psd<f64>>(negative, "[[1, 0], [2, -1]] is not a Cholesky factor in range");
    let slanted = r#"{"cholesky": [0, 2, 1]}"#;
    refused::<Psd<f64>>(slanted, "[[0, 0], [2, 1]] is not a Cholesky factor in range");
    let both = r#"{"entries": [1, 0, 1], "cholesky": [1, 0, 1]}"#;
    refused::<Psd<f32>>(both, "a matrix takes one of the fields `entries` and `cholesky`");
    refused::<Psd<f32>>("{}", "a matrix takes one of the fields `entries` and `cholesky`");
    let far = r#"{"columns": [[1, 2], [3, 2e9]]}"#;
    refused::<Kernel<f32>>(far, "column (3, 2e9) is not in [-1e9, 1e9]");
    refused::<Kernel<f32>>("{}", "a kernel takes one of the fields `covariance` and `columns`");
    refused::<Footprint<f32>>(r#"{"u": [1, 2], "v": [3, 4], "w": 5}"#, "unknown field `w`");
    // Written by hand, the determinant is that of the entries.
    let by_hand: Psd<f64> = serde_json::from_str(r#"{"entries": [4, 1, 4]}"#).expect("a matrix");
    assert_eq!(by_hand, Psd::new(4.0, 1.0, 4.0).expect("a matrix"));
    let beckmann = r#"{"distribution": "beckmann", "lobe": {"mean": [0, 0], "roughness":
        {"matrix": {"entries": [1, 0, 1]}}}, "fresnel": {"schlick": [1, 1, 1]}}"#;
    assert!(serde_json::from_str::<Material<BeckmannDistribution, f32>>(beckmann).is_ok());
    refused::<Material<GgxDistribution, f32>>(beckmann, "distribution is not ggx");
    let far = r#"{"mean": [2e9, 0], "covariance": {"entries": [0, 0, 0]}}"#;
    refused::<SlopeMoments<f32>>(far, "mean = 2e9 is not in [-1e9, 1e9]");
    let other = r#"{"alpha": 1, "beta": 2}"#;
    refused::<Isotropic<f32>>(other, "unknown field `beta`, expected `alpha`");
    let dull = r#"{"schlick": [0.5, 0.5, 1.5]}"#;
    refused::<Fresnel<f32>>(dull, "reflectance at normal incidence = 1.5 is not in [0, 1]");
    // A long thin kernel carries more of its determinant than its entries do.
    let thin = Psd::outer_sum([1.0_f32, 1.0], [1.0, 1.0 + 1e-4]);
    let text = serde_json::to_string(&thin).expect("numbers");
    assert_eq!(serde_json::from_str::<Psd<f32>>(&text).expect("known"), thin);
}
