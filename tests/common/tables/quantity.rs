//! The quantities that tables can hold: columns, and how the library computes them.

use lobe::slope::{Compensated, direction, jacobian};
use lobe::{
    AxisAligned, Beckmann, Distribution, Error, Footprint, Ggx, Kernel, Lobe, Ndf, Path, Psd, Real,
    Roughness, Vertex, filter,
};

/// One table stem of the contract.
#[derive(Debug)]
pub(crate) struct Quantity {
    /// The file's stem.
    pub(crate) stem: &'static str,
    /// Input columns, all exactly f32.
    pub(crate) inputs: &'static [&'static str],
    /// Columns of expected values.
    pub(crate) outputs: &'static [&'static str],
    /// Whether outputs can be negative.
    pub(crate) signed: bool,
    formula: Formula,
}

#[derive(Debug)]
enum Formula {
    SlopePdf(Name),
    D(Name),
    ProjectedArea(Name),
    Lambda(Name),
    Brdf(Name),
    BeckmannRectangle,
    GgxRectangle,
    GgxParallelogram,
    GgxGaussian,
    RectangleProxy,
    GaussianProxy,
    Jacobians,
    HalfSlopeJacobian,
    Chermain,
}

#[derive(Clone, Copy, Debug)]
enum Name {
    Beckmann,
    Ggx,
}

const EXPECTED: &[&str] = &["expected"];
const SLOPE: &[&str] = &["slope_x", "slope_y", "mean_x", "mean_y", "a_xx", "a_xy", "a_yy"];
const NORMAL: &[&str] = &["m_x", "m_y", "m_z", "a_xx", "a_xy", "a_yy"];
const AREA: &[&str] = &["w_x", "w_y", "w_z", "mean_x", "mean_y", "a_xx", "a_xy", "a_yy"];
const MASKED: &[&str] = &["w_x", "w_y", "w_z", "a_xx", "a_xy", "a_yy"];
const LIT: &[&str] =
    &["wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z", "mean_x", "mean_y", "a_xx", "a_xy", "a_yy"];
const RECTANGLE: &[&str] = &["slope_x", "slope_y", "half_x", "half_y", "alpha_x", "alpha_y"];
const PARALLELOGRAM: &[&str] =
    &["slope_x", "slope_y", "u_x", "u_y", "v_x", "v_y", "a_xx", "a_xy", "a_yy"];
const GAUSSIAN: &[&str] = &["slope_x", "slope_y", "k_xx", "k_xy", "k_yy", "a_xx", "a_xy", "a_yy"];
const MATRIX: &[&str] = &["m_11", "m_12", "m_21", "m_22"];

const fn quantity(
    stem: &'static str,
    inputs: &'static [&'static str],
    formula: Formula,
) -> Quantity {
    Quantity { stem, inputs, outputs: EXPECTED, signed: false, formula }
}

const fn matrix(
    stem: &'static str,
    inputs: &'static [&'static str],
    outputs: &'static [&'static str],
    formula: Formula,
) -> Quantity {
    Quantity { stem, inputs, outputs, signed: true, formula }
}

static QUANTITIES: &[Quantity] = &[
    quantity("beckmann_p22", SLOPE, Formula::SlopePdf(Name::Beckmann)),
    quantity("ggx_p22", SLOPE, Formula::SlopePdf(Name::Ggx)),
    quantity("beckmann_d", NORMAL, Formula::D(Name::Beckmann)),
    quantity("ggx_d", NORMAL, Formula::D(Name::Ggx)),
    quantity("beckmann_projected_area", AREA, Formula::ProjectedArea(Name::Beckmann)),
    quantity("ggx_projected_area", AREA, Formula::ProjectedArea(Name::Ggx)),
    quantity("beckmann_lambda", MASKED, Formula::Lambda(Name::Beckmann)),
    quantity("ggx_lambda", MASKED, Formula::Lambda(Name::Ggx)),
    quantity("beckmann_brdf", LIT, Formula::Brdf(Name::Beckmann)),
    quantity("ggx_brdf", LIT, Formula::Brdf(Name::Ggx)),
    quantity("beckmann_rectangle_mean", RECTANGLE, Formula::BeckmannRectangle),
    quantity("ggx_rectangle_mean", RECTANGLE, Formula::GgxRectangle),
    quantity("ggx_parallelogram_mean", PARALLELOGRAM, Formula::GgxParallelogram),
    quantity("ggx_gaussian_mean", GAUSSIAN, Formula::GgxGaussian),
    quantity("ggx_proxy_rectangle_alpha", &["alpha", "width"], Formula::RectangleProxy),
    quantity("ggx_proxy_gaussian_alpha", &["alpha", "sigma"], Formula::GaussianProxy),
    matrix(
        "jacobians",
        &["h_x", "h_y"],
        &[
            "sphere_to_slope_11",
            "sphere_to_slope_12",
            "sphere_to_slope_21",
            "sphere_to_slope_22",
            "sphere_to_projected_11",
            "sphere_to_projected_12",
            "sphere_to_projected_21",
            "sphere_to_projected_22",
            "projected_to_slope_11",
            "projected_to_slope_12",
            "projected_to_slope_21",
            "projected_to_slope_22",
        ],
        Formula::Jacobians,
    ),
    matrix(
        "half_slope_jacobian",
        &["e_x", "e_y", "e_z", "l_x", "l_y", "l_z", "b_11", "b_12", "b_22"],
        MATRIX,
        Formula::HalfSlopeJacobian,
    ),
    matrix("chermain_m", &["sigma_x", "sigma_y", "rho", "sigma_o"], MATRIX, Formula::Chermain),
];

/// The quantity that a table's stem names.
pub(crate) fn quantity_of(stem: &str) -> Option<&'static Quantity> {
    QUANTITIES.iter().find(|quantity| quantity.stem == stem)
}

/// Outputs from inputs, or why the inputs are refused.
type Evaluator<R> = fn(&[R]) -> Result<Vec<R>, Error>;

impl Quantity {
    /// The function of this quantity in the precision `R`.
    pub(crate) fn evaluator<R: Real>(&self) -> Evaluator<R> {
        match self.formula {
            Formula::SlopePdf(Name::Beckmann) => {
                |x| Ok(slope_pdf(&Beckmann::new(lobe(&x[2..])?), x))
            }
            Formula::SlopePdf(Name::Ggx) => |x| Ok(slope_pdf(&Ggx::new(lobe(&x[2..])?), x)),
            Formula::D(Name::Beckmann) => {
                |x| Ok(vec![Beckmann::new(centered(&x[3..])?).d(vector(x))])
            }
            Formula::D(Name::Ggx) => |x| Ok(vec![Ggx::new(centered(&x[3..])?).d(vector(x))]),
            Formula::ProjectedArea(Name::Beckmann) => {
                |x| Ok(vec![Beckmann::new(lobe(&x[3..])?).projected_area(vector(x))])
            }
            Formula::ProjectedArea(Name::Ggx) => {
                |x| Ok(vec![Ggx::new(lobe(&x[3..])?).projected_area(vector(x))])
            }
            Formula::Lambda(Name::Beckmann) => {
                |x| Ok(vec![Beckmann::new(centered(&x[3..])?).lambda(vector(x))])
            }
            Formula::Lambda(Name::Ggx) => {
                |x| Ok(vec![Ggx::new(centered(&x[3..])?).lambda(vector(x))])
            }
            Formula::Brdf(Name::Beckmann) => {
                |x| Ok(vec![Beckmann::new(lobe(&x[6..])?).brdf(vector(x), vector(&x[3..]))])
            }
            Formula::Brdf(Name::Ggx) => {
                |x| Ok(vec![Ggx::new(lobe(&x[6..])?).brdf(vector(x), vector(&x[3..]))])
            }
            Formula::BeckmannRectangle => |x| {
                AxisAligned::new(x[4], x[5])?;
                let widths = [x[2] + x[2], x[3] + x[3]];
                Ok(vec![filter::beckmann_rectangle_mean([x[4], x[5]], [x[0], x[1]], widths)])
            },
            Formula::GgxRectangle => |x| {
                let ggx = Ggx::new(AxisAligned::new(x[4], x[5])?);
                Ok(vec![ggx.rectangle_mean([x[0], x[1]], [x[2] + x[2], x[3] + x[3]])])
            },
            Formula::GgxParallelogram => |x| {
                let footprint = Footprint::from_slopes([x[2], x[3]], [x[4], x[5]]);
                Ok(vec![Ggx::new(centered(&x[6..])?).parallelogram_mean([x[0], x[1]], &footprint)])
            },
            Formula::GgxGaussian => |x| {
                let kernel = Kernel::from_covariance(Psd::new(x[2], x[3], x[4])?);
                let lobe = Lobe::centered(roughness(&x[5..])?);
                Ok(vec![filter::ggx_gaussian_mean(&lobe, [x[0], x[1]], &kernel)])
            },
            Formula::RectangleProxy => |x| Ok(vec![filter::box_peak_alpha(x[0], x[1])?]),
            Formula::GaussianProxy => |x| Ok(vec![filter::gaussian_peak_alpha(x[0], x[1])?]),
            Formula::Jacobians => |x| {
                let h = direction::from_disk([x[0], x[1]]);
                let matrices = [
                    jacobian::sphere_to_slope(h),
                    jacobian::sphere_to_disk(h),
                    jacobian::disk_to_slope(h),
                ];
                Ok(matrices.as_flattened().as_flattened().to_vec())
            },
            Formula::HalfSlopeJacobian => |x| {
                let path = Path {
                    eye: Vertex::at(vector(x))?,
                    light: Vertex::at(vector(&x[3..]))?,
                    curvature: [x[6], x[7], x[8]],
                };
                Ok(path.slope_jacobian().as_flattened().to_vec())
            },
            Formula::Chermain => |x| {
                let roughness = Roughness::from_sigma_rho(x[0], x[1], x[2])?;
                Ok(roughness.chermain_matrix(x[3]).as_flattened().to_vec())
            },
        }
    }
}

fn slope_pdf<R: Real, D: Distribution>(ndf: &Ndf<D, Compensated<R>>, x: &[R]) -> Vec<R> {
    vec![ndf.slope_pdf([x[0], x[1]])]
}

fn vector<R: Real>(x: &[R]) -> [R; 3] {
    [x[0], x[1], x[2]]
}

fn roughness<R: Real>(x: &[R]) -> Result<Roughness<R>, Error> {
    Ok(Roughness::from_matrix(Psd::new(x[0], x[1], x[2])?))
}

/// From `a_xx, a_xy, a_yy`.
fn centered<R: Real>(x: &[R]) -> Result<Compensated<R>, Error> {
    Compensated::new([R::ZERO; 2], vector(x))
}

/// From `mean_x, mean_y, a_xx, a_xy, a_yy`.
fn lobe<R: Real>(x: &[R]) -> Result<Compensated<R>, Error> {
    Compensated::new([x[0], x[1]], vector(&x[2..]))
}
