//! The quantities that tables can hold: columns, and how the library computes them.

use super::shapes::{Exact, Factored, Promise, Shapes};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::slope::{direction, jacobian};
use lobe::{
    AxisAligned, Distribution, Error, Footprint, Ggx, Kernel, Lobe, Ndf, Path, Psd, Real,
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

/// How a quantity is computed.
#[derive(Debug)]
enum Formula {
    /// What is promised of every shape of matrix entries, compensated or default.
    Shape(Name, Query),
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

/// What a distribution over a shape is asked.
#[derive(Clone, Copy, Debug)]
enum Query {
    SlopePdf,
    D,
    ProjectedArea,
    Lambda,
    Brdf,
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
    quantity("beckmann_p22", SLOPE, Formula::Shape(Name::Beckmann, Query::SlopePdf)),
    quantity("ggx_p22", SLOPE, Formula::Shape(Name::Ggx, Query::SlopePdf)),
    quantity("beckmann_d", NORMAL, Formula::Shape(Name::Beckmann, Query::D)),
    quantity("ggx_d", NORMAL, Formula::Shape(Name::Ggx, Query::D)),
    quantity("beckmann_projected_area", AREA, Formula::Shape(Name::Beckmann, Query::ProjectedArea)),
    quantity("ggx_projected_area", AREA, Formula::Shape(Name::Ggx, Query::ProjectedArea)),
    quantity("beckmann_lambda", MASKED, Formula::Shape(Name::Beckmann, Query::Lambda)),
    quantity("ggx_lambda", MASKED, Formula::Shape(Name::Ggx, Query::Lambda)),
    quantity("beckmann_brdf", LIT, Formula::Shape(Name::Beckmann, Query::Brdf)),
    quantity("ggx_brdf", LIT, Formula::Shape(Name::Ggx, Query::Brdf)),
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
pub(super) type Evaluator<R> = fn(&[R]) -> Result<Vec<R>, Error>;

impl Quantity {
    /// What the quantity is judged by. Means over polygons are promised forward accuracy only.
    pub(crate) fn promises(&self) -> &'static [Promise] {
        match self.formula {
            Formula::Shape(..) => &[Promise::Forward, Promise::Backward],
            _ => &[Promise::Forward],
        }
    }

    /// The function of this quantity in the precision `R` that a promise judges.
    pub(super) fn evaluator<R: Real>(&self, promise: Promise) -> Evaluator<R> {
        match self.formula {
            Formula::Shape(name, query) => match promise {
                Promise::Forward => of_shape::<R, Exact>(name, query),
                Promise::Backward => of_shape::<R, Factored>(name, query),
            },
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
                let ggx = Ggx::new(Exact::centered(vector(&x[6..]))?);
                Ok(vec![ggx.parallelogram_mean([x[0], x[1]], &footprint)])
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

fn of_shape<R: Real, S: Shapes<R>>(name: Name, query: Query) -> Evaluator<R> {
    match name {
        Name::Beckmann => asked::<R, S, BeckmannDistribution>(query),
        Name::Ggx => asked::<R, S, GgxDistribution>(query),
    }
}

fn asked<R: Real, S: Shapes<R>, D: Distribution>(query: Query) -> Evaluator<R> {
    match query {
        Query::SlopePdf => |x| Ok(vec![moved::<R, S, D>(&x[2..])?.slope_pdf([x[0], x[1]])]),
        Query::D => |x| Ok(vec![centered::<R, S, D>(&x[3..])?.d(vector(x))]),
        Query::ProjectedArea => |x| Ok(vec![moved::<R, S, D>(&x[3..])?.projected_area(vector(x))]),
        Query::Lambda => |x| Ok(vec![centered::<R, S, D>(&x[3..])?.lambda(vector(x))]),
        Query::Brdf => |x| Ok(vec![moved::<R, S, D>(&x[6..])?.brdf(vector(x), vector(&x[3..]))]),
    }
}

fn vector<R: Real>(x: &[R]) -> [R; 3] {
    [x[0], x[1], x[2]]
}

fn roughness<R: Real>(x: &[R]) -> Result<Roughness<R>, Error> {
    Ok(Roughness::from_matrix(Psd::new(x[0], x[1], x[2])?))
}

/// From `a_xx, a_xy, a_yy`.
fn centered<R: Real, S: Shapes<R>, D: Distribution>(x: &[R]) -> Result<Ndf<D, S::Centered>, Error> {
    Ok(Ndf::new(S::centered(vector(x))?))
}

/// From `mean_x, mean_y, a_xx, a_xy, a_yy`.
fn moved<R: Real, S: Shapes<R>, D: Distribution>(x: &[R]) -> Result<Ndf<D, S::Moved>, Error> {
    Ok(Ndf::new(S::moved([x[0], x[1]], vector(&x[2..]))?))
}
