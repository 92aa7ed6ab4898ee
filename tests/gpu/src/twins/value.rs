//! How Rust reads the floats of a twin, and how either language writes its result.

use lobe::filter::DiskKernel;
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, Glints};
use lobe::material::leadr::{Facet, Leadr, Node};
use lobe::material::multilobe::MultiLobe;
use lobe::slope::{Extent, Motion, Widened};
use lobe::{
    Alphas, Eigen, Footprint, Isotropic, Kernel, Lobe, PixelFilter, Psd, Real, Roughness,
    SlopeMoments, Vertex,
};

/// Reads a twin's floats in their order, in any precision.
#[derive(Debug)]
pub struct Reader<'a> {
    floats: &'a [f32],
    next: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(floats: &'a [f32]) -> Self {
        Self { floats, next: 0 }
    }

    /// One number as it is.
    pub(super) fn raw(&mut self) -> f32 {
        self.next += 1;
        self.floats[self.next - 1]
    }

    pub(super) fn f<R: Real>(&mut self) -> R {
        R::lit(f64::from(self.raw()))
    }

    pub(super) fn vec<R: Real, const N: usize>(&mut self) -> [R; N] {
        [0; N].map(|_| self.f())
    }

    pub(super) fn psd<R: Real>(&mut self) -> Psd<R> {
        let [xx, xy, yy] = self.vec();
        Psd::new(xx, xy, yy).unwrap_or_default()
    }

    pub(super) fn roughness<R: Real>(&mut self) -> Roughness<R> {
        Roughness::from_matrix(self.psd())
    }

    pub(super) fn lobe<R: Real>(&mut self) -> Lobe<R> {
        let roughness = self.roughness();
        Lobe::new(self.vec(), roughness).unwrap_or_default()
    }

    pub(super) fn footprint<R: Real>(&mut self) -> Footprint<R> {
        Footprint { u: self.vec(), v: self.vec() }
    }

    pub(super) fn kernel<R: Real>(&mut self) -> Kernel<R> {
        let Footprint { u, v } = self.footprint();
        Kernel::from_columns(u, v).unwrap_or_default()
    }

    pub(super) fn widened<R: Real>(&mut self) -> Widened<Isotropic<R>> {
        let shape = Isotropic::saturating(self.f());
        let [u, v] = self.kernel().columns();
        Widened::new(shape, u, v)
    }

    pub(super) fn disk<R: Real>(&mut self) -> DiskKernel<R> {
        DiskKernel::from_covariance(self.kernel().covariance())
    }

    /// A matrix, rows first.
    pub(super) fn matrix<R: Real>(&mut self) -> [[R; 2]; 2] {
        [self.vec(), self.vec()]
    }

    pub(super) fn node<R: Real>(&mut self) -> Node<R> {
        Node { place: self.vec(), weight: self.f(), extent: self.f() }
    }

    pub(super) fn leadr<R: Real>(&mut self) -> Leadr<R> {
        Leadr::new(&self.lobe())
    }

    /// Any bits.
    pub(super) fn word(&mut self) -> u32 {
        self.raw().to_bits()
    }

    pub(super) fn index(&mut self) -> [i32; 2] {
        [self.word(), self.word()].map(u32::cast_signed)
    }

    pub(super) fn biscale<R: Real>(&mut self) -> Biscale<R> {
        let alphas = self.vec::<R, 2>();
        Biscale::from_fractions(alphas, self.vec::<R, 2>()).expect("drawn fractions are in range")
    }

    pub(super) fn glints<R: Real>(&mut self) -> Glints<R> {
        let biscale = self.biscale();
        let glints = Glints::new(biscale, self.f());
        let glints = glints.and_then(|glints| glints.with_variation(self.f()));
        let glints = glints.and_then(|glints| glints.with_share(self.f()));
        glints.expect("drawn numbers are in range").with_seed(self.word())
    }

    pub(super) fn facets<R: Real>(&mut self) -> MultiLobe<R> {
        let facets = MultiLobe::new(self.roughness(), self.f());
        let facets = facets.and_then(|facets| facets.with_variation(self.f()));
        let facets = facets.and_then(|facets| facets.with_share(self.f()));
        facets.expect("drawn numbers are in range").with_seed(self.word())
    }

    pub(super) fn patch<R: Real>(&mut self) -> Patch<R> {
        let tile = self.index();
        Patch::in_tile(tile, self.vec::<R, 2>(), self.vec::<R, 2>(), self.vec::<R, 2>())
    }

    pub(super) fn filter(&mut self) -> PixelFilter {
        PixelFilter::with_variance(f64::from(self.raw())).expect("a drawn variance is in range")
    }
}

/// A result as a list of numbers.
pub(super) trait Flat<R> {
    /// The WGSL statements that write `r`, from place 0 on; `put` of a place and a value.
    const WGSL: &'static str;
    fn flat(self, out: &mut Vec<R>);
}

impl<R: Real> Flat<R> for R {
    const WGSL: &'static str = "put(0u, r);";
    fn flat(self, out: &mut Vec<R>) {
        out.push(self);
    }
}

impl<R: Real> Flat<R> for [R; 2] {
    const WGSL: &'static str = "put(0u, r.x); put(1u, r.y);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend(self);
    }
}

impl<R: Real> Flat<R> for [R; 3] {
    const WGSL: &'static str = "put(0u, r.x); put(1u, r.y); put(2u, r.z);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend(self);
    }
}

/// A matrix: rows first in Rust, columns first in WGSL.
impl<R: Real> Flat<R> for [[R; 2]; 2] {
    const WGSL: &'static str =
        "put(0u, r[0][0]); put(1u, r[1][0]); put(2u, r[0][1]); put(3u, r[1][1]);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend(self.concat());
    }
}

/// Two vectors, which are the columns in WGSL.
pub(super) struct Columns<R>(pub(super) [[R; 2]; 2]);

impl<R: Real> Flat<R> for Columns<R> {
    const WGSL: &'static str =
        "put(0u, r[0].x); put(1u, r[0].y); put(2u, r[1].x); put(3u, r[1].y);";
    fn flat(self, out: &mut Vec<R>) {
        out.extend(self.0.concat());
    }
}

/// Writes `Flat` for a structure: its WGSL fields and its Rust numbers.
macro_rules! flat {
    ($($type:ident: $wgsl:literal, |$x:ident| $numbers:expr;)*) => {
        $(impl<R: Real> Flat<R> for $type<R> {
            const WGSL: &'static str = $wgsl;
            fn flat(self, out: &mut Vec<R>) {
                let $x = self;
                out.extend($numbers);
            }
        })*
    };
}

flat! {
    Biscale: "let s = r.spread.psd; put(0u, s.l_xx); put(1u, s.l_yx); put(2u, s.l_yy);
              let l = r.local.psd; put(3u, l.l_xx); put(4u, l.l_yx); put(5u, l.l_yy);",
        |x| [x.spread().matrix().cholesky(), x.local().matrix().cholesky()].concat();
    Psd: "put(0u, r.l_xx); put(1u, r.l_yx); put(2u, r.l_yy);", |x| x.cholesky();
    Roughness: "let m = r.psd; put(0u, m.l_xx); put(1u, m.l_yx); put(2u, m.l_yy);",
        |x| x.matrix().cholesky();
    Kernel: "put(0u, r.u.x); put(1u, r.u.y); put(2u, r.v.x); put(3u, r.v.y);",
        |x| x.columns().concat();
    DiskKernel: "let k = r.as_slopes; put(0u, k.u.x); put(1u, k.u.y); put(2u, k.v.x); \
        put(3u, k.v.y);",
        |x| x.as_slopes().columns().concat();
    Extent: "put(0u, r.root_det); put(1u, r.unit); put(2u, r.scale);",
        |x| [x.root_det, x.unit, x.scale];
    Lobe: "let m = r.roughness.psd; put(0u, r.mean.x); put(1u, r.mean.y); put(2u, m.l_xx);
           put(3u, m.l_yx); put(4u, m.l_yy);",
        |x| x.mean().into_iter().chain(x.roughness().matrix().cholesky());
    SlopeMoments: "let m = r.covariance; put(0u, r.mean.x); put(1u, r.mean.y); put(2u, m.l_xx);
                   put(3u, m.l_yx); put(4u, m.l_yy);",
        |x| x.mean().into_iter().chain(x.covariance().cholesky());
    Footprint: "put(0u, r.u.x); put(1u, r.u.y); put(2u, r.v.x); put(3u, \
        r.v.y);", |x| [x.u, x.v].concat();
    Eigen: "put(0u, r.major); put(1u, r.minor); put(2u, r.axis.x); put(3u, r.axis.y);",
        |x| [x.major, x.minor, x.axis[0], x.axis[1]];
    Alphas: "put(0u, r.major); put(1u, r.minor); put(2u, \
        r.angle);", |x| [x.major, x.minor, x.angle];
    Motion: "let h = r.half_vector; put(0u, h.x); put(1u, h.y); put(2u, h.z); put(3u, r.normal.x);
             put(4u, r.normal.y); put(5u, r.spin);",
        |x| x.half_vector.into_iter().chain(x.normal).chain([x.spin]);
    Facet: "put(0u, r.normal.x); put(1u, r.normal.y); put(2u, r.normal.z); put(3u, r.wi.x); \
        put(4u, r.wi.y);
            put(5u, r.wi.z); put(6u, r.cosine); put(7u, r.area); put(8u, r.solid_angle);",
        |x| x.normal.into_iter().chain(x.wi).chain([x.cosine, x.area, x.solid_angle]);
    Vertex: "let w = r.direction; put(0u, w.x); put(1u, w.y); put(2u, w.z); put(3u, \
        r.inverse_distance);",
        |x| x.direction.into_iter().chain([x.inverse_distance]);
}
