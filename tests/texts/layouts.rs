//! Structures of `lobe::gpu` lie in a storage buffer as WGSL lays out those of the port.
#![cfg(all(feature = "bytemuck", feature = "wgsl", feature = "glint"))]

use crate::entry::parse;
use core::mem::{offset_of, size_of};
use lobe::filter::{DiskKernel, SphericalGaussian};
use lobe::gpu;
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, Glints};
use lobe::material::multilobe::MultiLobe;
use lobe::slope::Motion;
use lobe::wgsl::{Item, source};
use lobe::{Anisotropic, Footprint, Kernel, Lobe, Path, Psd, Roughness, SlopeMoments, Vertex};
use naga::TypeInner;

/// Name, size and the places of named fields of a structure in Rust.
struct Layout {
    name: &'static str,
    size: usize,
    fields: Vec<(&'static str, usize)>,
}

macro_rules! layouts {
    ($($name:literal $type:ident { $($field:ident $wgsl:literal),* $(,)? })*) => {
        vec![$(Layout {
            name: $name,
            size: size_of::<gpu::$type>(),
            fields: vec![$(($wgsl, offset_of!(gpu::$type, $field))),*],
        }),*]
    };
}

#[test]
fn structures_lie_as_the_port_has_them() {
    let layouts: Vec<Layout> = layouts! {
        "LobePsd" Psd { l_xx "l_xx", l_yx "l_yx", l_yy "l_yy" }
        "LobeRoughness" Psd { l_xx "psd" }
        "LobeKernel" Columns { u "u", v "v" }
        "LobeDiskKernel" Columns { u "as_slopes" }
        "LobeFootprint" Footprint { u "u", v "v" }
        "LobeSlopeMoments" SlopeMoments { mean "mean", covariance "covariance" }
        "LobeLobe" Lobe { mean "mean", roughness "roughness" }
        "LobeAnisotropic" Anisotropic { factor "factor", root_det "root_det" }
        "LobeSphericalGaussian" SphericalGaussian {
            direction "direction", sharpness "sharpness"
        }
        "LobeNonCentered" NonCentered { shape "shape", mean "mean" }
        "LobeVertex" Vertex { direction "direction", inverse_distance "inverse_distance" }
        "LobePath" Path { eye "eye", light "light", curvature "curvature" }
        "LobeMotion" Motion { half_vector "half_vector", normal "normal", spin "spin" }
        "LobeBiscale" Biscale { spread "spread", local "local" }
        "LobeGlints" Glints {
            biscale "biscale", density "density", variation "variation", share "share",
            stretch "stretch", groove "groove", seed "seed"
        }
        "LobeMultiLobe" MultiLobe {
            roughness "roughness", density "density", variation "variation", share "share",
            seed "seed"
        }
        "LobePatch" Patch { tile "tile", uv "uv", right "right", up "up" }
    };
    let (module, _) = parse(&source(Item::ALL)).expect("valid");
    let of_name = |name: &str| {
        let found = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(name));
        match found.map(|(_, ty)| &ty.inner) {
            Some(TypeInner::Struct { members, span }) => (members, *span as usize),
            other => panic!("{name}: {other:?}"),
        }
    };
    for Layout { name, size, fields } in layouts {
        let (members, span) = of_name(name);
        assert_eq!(size, span, "the size of {name}");
        for (field, place) in &fields {
            let member = members.iter().find(|member| member.name.as_deref() == Some(*field));
            let offset = member.unwrap_or_else(|| panic!("{name}.{field}")).offset;
            assert_eq!(*place, offset as usize, "{name}.{field}");
        }
        assert_eq!(members.len(), fields.len(), "the members of {name}");
    }
}

/// The floats of a structure.
fn floats<T: bytemuck::Pod>(value: T) -> Vec<f32> {
    bytemuck::cast_slice(&[value]).to_vec()
}

#[test]
fn every_number_lies_in_its_own_place() {
    let psd = Psd::from_cholesky([4.0_f32, 1.0, 2.0]).expect("a factor");
    assert_eq!(floats(gpu::Psd::from(psd)), [4.0, 1.0, 2.0]);
    let kernel = Kernel::from_columns([4.0, 1.0], [3.0, 2.0]).expect("in range");
    assert_eq!(floats(gpu::Columns::from(kernel)), [4.0, 1.0, 3.0, 2.0]);
    let root = |x: f32| x * core::f32::consts::SQRT_2;
    let columns = [root(4.0), root(1.0), 0.0, root(2.0)];
    assert_eq!(floats(gpu::Columns::from(DiskKernel::from_covariance(psd))), columns);
    let footprint = Footprint::from_slopes([1.0, 2.0], [3.0, 4.0]);
    assert_eq!(floats(gpu::Footprint::from(footprint)), [1.0, 2.0, 3.0, 4.0]);
    let moments = SlopeMoments::new([5.0, 6.0], psd).expect("in range");
    let want = [5.0, 6.0, 4.0, 1.0, 2.0, 0.0];
    assert_eq!(floats(gpu::SlopeMoments::from(moments)), want);
    let lobe = Lobe::new([5.0, 6.0], Roughness::from_matrix(psd)).expect("in range");
    assert_eq!(floats(gpu::Lobe::from(lobe)), want);
    let shape = floats(gpu::Anisotropic::from(Anisotropic::new(lobe.roughness())));
    assert_eq!(shape, [4.0, 1.0, 2.0, 8.0]);
    assert_eq!(floats(gpu::NonCentered::from(lobe)), [&shape[..], &[5.0, 6.0]].concat());
    let vertex = |x: f32| Vertex { direction: [x, x + 1.0, x + 2.0], inverse_distance: x + 3.0 };
    let path = Path { eye: vertex(1.0), light: vertex(5.0), curvature: [9.0, 10.0, 11.0] };
    let counted: Vec<f32> = (1..12_u8).map(f32::from).chain([0.0]).collect();
    assert_eq!(floats(gpu::Path::from(path)), counted);
    let motion = Motion { half_vector: [1.0, 2.0, 3.0], normal: [4.0, 5.0], spin: 6.0 };
    let want = [1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 6.0, 0.0];
    assert_eq!(floats(gpu::Motion::from(motion)), want);
    let light = SphericalGaussian::new([0.0_f32, 0.0, 1.0], 7.0).expect("in range");
    assert_eq!(floats(gpu::SphericalGaussian::from(light)), [0.0, 0.0, 1.0, 7.0]);
}

#[test]
fn every_number_of_glints_lies_in_its_own_place() {
    let root = |x: f32| Psd::new(x, 0.0, x).expect("a matrix");
    let biscale = Biscale::new(
        Roughness::from_matrix(root(4.0)),
        Roughness::from_alphas(1.0, 2.0, 0.0).expect("in range"),
    );
    let glints = Glints::new(biscale, 8.0).and_then(|glints| glints.with_variation(3.0));
    let glints = glints.and_then(|glints| glints.with_share(0.5)).expect("in range").with_seed(9);
    let words = floats(gpu::Glints::from(glints));
    let halves = [2.0, 0.0, 2.0, 1.0, 0.0, 2.0];
    assert_eq!(words[..12], [&halves[..], &[8.0, 3.0, 0.5, 0.0, 1.0, 1.0]].concat());
    assert_eq!([words[12].to_bits(), words[13].to_bits()], [0, 9]);
    let along_v = Biscale::from_fractions([0.5_f32, 0.5], [0.5, 1.0]).expect("in range");
    let grooves = gpu::Glints::from(Glints::new(along_v, 8.0).expect("in range"));
    assert_eq!((grooves.stretch, grooves.groove), ([1.0, 0.0], 2));
    let facets = MultiLobe::new(Roughness::from_matrix(root(4.0)), 8.0).expect("in range");
    let facets = facets.with_variation(3.0).and_then(|facets| facets.with_share(0.5));
    let words = floats(gpu::MultiLobe::from(facets.expect("in range").with_seed(9)));
    assert_eq!(words[..6], [2.0, 0.0, 2.0, 8.0, 3.0, 0.5]);
    assert_eq!(words[6].to_bits(), 9);
    let patch = Patch::in_tile([-1, 2], [1.0_f32, 2.0], [3.0, 4.0], [5.0, 6.0]);
    let patch = gpu::Patch::from(patch);
    assert_eq!(patch.tile, [-1, 2]);
    assert_eq!((patch.uv, patch.right, patch.up), ([1.0, 2.0], [3.0, 4.0], [5.0, 6.0]));
}
