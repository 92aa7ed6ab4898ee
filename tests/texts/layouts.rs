//! Structures of `lobe::gpu` lie in a storage buffer as WGSL lays out those of the port.
#![cfg(all(feature = "bytemuck", feature = "wgsl", feature = "glint"))]

use crate::entry::parse;
use core::mem::{offset_of, size_of};
use lobe::gpu;
use lobe::wgsl::{Item, source};
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
        "LobePsd" Psd { entries "xx", root_det "root_det" }
        "LobeRoughness" Psd { entries "psd" }
        "LobeKernel" Psd { entries "covariance" }
        "LobeDiskKernel" Psd { entries "as_slopes" }
        "LobeFootprint" Footprint { u "u", v "v" }
        "LobeSlopeMoments" SlopeMoments { mean "mean", covariance "covariance" }
        "LobeLobe" Lobe { mean "mean", roughness "roughness" }
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
        // Of a matrix the entries are one array.
        let all = members.len() == fields.len() || name == "LobePsd";
        assert!(all, "{name} has {} members", members.len());
    }
    let (members, _) = of_name("LobeAnisotropic");
    let names: Vec<&str> = members.iter().filter_map(|member| member.name.as_deref()).collect();
    let order = ["xx", "xy", "root_det", "inverse_xx", "along", "across", "schur"];
    assert_eq!(names, order, "`Anisotropic::numbers` lists them in this order");
}
