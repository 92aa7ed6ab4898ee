//! What one cell costs whatever the machine: operations on floats, and instructions of the shader.

use lobe::Error;
use lobe::probe::{Counted, operations_of};
use lobe::wgsl::{Item, source};
use serde::Serialize;

use super::cells::whole;
use super::material::snow;
use super::model::{Made, Model, Seen};
use super::sample::Pixel;
use crate::method::Tally;
use crate::spirv::{assembled, instructions};

/// Operations on floats of the default model; integers and hashes are not counted.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct PerCell {
    /// In a pixel.
    pub(crate) details: f64,
    pub(crate) cell: Tally,
    /// What a pixel has beside its cells, the smooth lobe included.
    pub(crate) pixel: Tally,
}

/// Details in a pixel.
const DETAILS: [f64; 3] = [10.0, 1e3, 1e5];

/// Pixels of each of two aspects.
const PIXELS: u64 = 200;

/// Of every number of details.
pub(super) fn per_cell() -> Result<Vec<PerCell>, Error> {
    DETAILS.into_iter().map(PerCell::of).collect()
}

impl PerCell {
    fn of(details: f64) -> Result<Self, Error> {
        let material = snow("", details);
        // Between the two aspects nothing differs but the number of cells.
        let [short, long] = [1.0, 16.0].map(|aspect| {
            let (mut tally, mut cells) = (Tally::default(), 0.0);
            for index in 0..PIXELS {
                let pixel = Pixel::random(aspect, None, index);
                cells += whole(&Made::new(&material, pixel.area, 0)?, &pixel.patch) / PIXELS as f64;
                let made = Made::<Counted>::new(&material, pixel.area, 0)?;
                let up = [0.0, 0.0, 1.0];
                let seen = Seen { patch: pixel.patch, wo: up, wi: up, radius: 0.0 }.cast();
                let (_, operations) = operations_of(|| made.brdf(Model::Default, &seen));
                tally = tally.plus(&Tally::of(operations, 1), 1.0 / PIXELS as f64);
            }
            Ok((tally, cells))
        });
        let ((short, few), (long, many)) = (short?, long?);
        let difference = long.plus(&short, -1.0);
        let cell = Tally::default().plus(&difference, 1.0 / (many - few));
        Ok(Self { details, cell, pixel: short.plus(&cell, -few) })
    }
}

/// Static SPIR-V instructions of the shader, calls written out, loops counted once: all, and those
/// that compute.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Instructions {
    /// Of the innermost loop: all that is done for a cell.
    pub(crate) cell: [usize; 2],
    /// Those of them that only numbers of details that vary need.
    pub(crate) varied: [usize; 2],
    /// Of the whole: a pixel's lobe, and its BRDF under a light.
    pub(crate) whole: [usize; 2],
}

impl Instructions {
    /// Of the text that the library gives out.
    pub(super) fn counted() -> Result<Self, String> {
        let words = assembled(&source(&[Item::GlintsNdf, Item::GlintNdfBrdf]))?;
        let functions = instructions(&words);
        let of = |names: &[&str]| {
            names.iter().try_fold([0; 2], |[all, arithmetic], name| {
                let found = functions.iter().find(|function| function.name == *name);
                let found = found.ok_or(format!("no function {name}"))?;
                Ok::<_, String>([all + found.inlined, arithmetic + found.arithmetic])
            })
        };
        Ok(Self {
            cell: of(&["lobe_level_covered", "lobe_glint_ndf_cell"])?,
            varied: of(&["lobe_glint_ndf_varied"])?,
            whole: of(&["lobe_glints_ndf", "lobe_glint_ndf_brdf"])?,
        })
    }
}
