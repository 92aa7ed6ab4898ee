//! What the machine needs for a row's divisions, square roots, loads and its store alone: the limit
//! of any code that does as many.

use super::columns::{Column, EMPTY};
use super::samples::COUNT;
use std::hint::black_box;

/// What a row does for one sample. Additions and products run beside these and are not counted.
/// Neither are divisions inside of transcendental functions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Operations {
    pub(crate) divisions: usize,
    pub(crate) roots: usize,
    /// Numbers that are read.
    pub(crate) loads: usize,
}

/// Samples that are in registers at once.
const LANES: usize = 16;

/// The sum over a few columns of `f` of each.
#[inline(always)]
fn add(sum: &mut [f32; LANES], columns: &[&Column], start: usize, f: impl Fn(f32) -> f32) {
    for column in columns {
        let numbers: &[f32; LANES] = column[start..][..LANES].try_into().expect("all lanes");
        for (sum, &number) in sum.iter_mut().zip(numbers) {
            *sum += f(number);
        }
    }
}

/// For each sample a quotient, a root or nothing else of each column, and their sum, which none of
/// them waits for.
#[inline(never)]
fn loop_of_limit(divide: &[&Column], root: &[&Column], load: &[&Column], out: &mut Column) {
    for start in (0..COUNT).step_by(LANES) {
        let mut sum = [0.0; LANES];
        add(&mut sum, divide, start, |x| 1.0 / x);
        add(&mut sum, root, start, f32::sqrt);
        add(&mut sum, load, start, |x| x);
        out[start..][..LANES].copy_from_slice(&sum);
    }
}

/// One pass of the limit over all samples.
pub(crate) fn pass(Operations { divisions, roots, loads }: Operations) -> Box<dyn FnMut()> {
    let columns: Vec<Column> = (0..loads).map(|k| EMPTY.map(|_| 1.5 + k as f32)).collect();
    let mut out: Box<Column> = Box::new(EMPTY);
    Box::new(move || {
        // More operations than columns read some of them again.
        let mut next = columns.iter().cycle();
        let mut some = |count: usize| -> Vec<&Column> { next.by_ref().take(count).collect() };
        let (divide, root) = (some(divisions), some(roots));
        let load = some(loads.saturating_sub(divisions + roots));
        loop_of_limit(black_box(&divide), black_box(&root), black_box(&load), &mut out);
        black_box(&out);
    })
}
