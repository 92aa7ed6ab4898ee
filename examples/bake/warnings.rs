//! Warnings about a baked map: what it looks like, for the user to judge.

use super::looks::{self, Green};
use super::options::Options;
use super::slopes::Slopes;
use super::survey::Survey;
use lobe::material::lean::{ClippedTexels, MomentMap};

/// A map's slopes as their file has them, before the chain takes them.
pub(crate) struct Looks {
    lines: Vec<String>,
    clipped: ClippedTexels,
    survey: Survey,
}

impl Looks {
    /// The looks of slopes; `ignored` is what
    /// [`Picture::ignored`](super::picture::Picture::ignored) says of their picture.
    pub(crate) fn of(slopes: &Slopes, ignored: Option<String>, options: &Options) -> Self {
        let mut lines: Vec<_> = ignored.into_iter().collect();
        if options.height.is_none() {
            lines.extend(slopes.survey.hints());
        }
        Self { lines, clipped: slopes.clipped, survey: slopes.survey.clone() }
    }

    /// All lines, by the chain of the map.
    pub(crate) fn warnings(mut self, map: &MomentMap<f32>, options: &Options) -> Vec<String> {
        let normals = options.height.is_none();
        let clear = if normals { clear(&self.survey) } else { None };
        match (looks::clipped(self.clipped, &format!("--cap {}", options.steepest())), clear) {
            (Some(clipped), Some(clear)) => self.lines.push(format!("{clipped}; {clear}")),
            (Some(clipped), None) => self.lines.push(clipped),
            (None, Some(clear)) if self.survey.is_masked() => self.lines.push(clear),
            (None, _) => {}
        }
        let flipped = options.flip_y;
        let remedy = if flipped { "leave --flip-y out" } else { "--flip-y" };
        self.lines.extend(looks::lines(map, normals.then_some(Green { flipped, remedy })));
        self.lines
    }
}

/// Texels of alpha 0 that count like all others, and the option that leaves them out.
pub(crate) fn clear(survey: &Survey) -> Option<String> {
    survey.clear().map(|line| line + ", which --coverage leaves out")
}
