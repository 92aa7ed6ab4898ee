//! The loop of every batch: blocks of elements, under the best instructions of the machine.
//!
//! Layer 5.

use super::columns::Columns;
use crate::error::{Error, same_length};
use crate::scalar::Real;

/// How many elements are computed before they are written.
///
/// Results of a block stand in arrays of the stack, which no column can overlap: a loop over any
/// number of columns becomes lanes without tests of addresses.
const BLOCK: usize = 256;

/// Writes `f` of each element, by the best instructions that the machine has.
///
/// Formulas take a * b + c by two roundings whatever the instructions are, so every one of them
/// gives the same bits.
pub(super) fn fill<C: Columns, R: Real, const N: usize>(
    columns: C,
    mut out: [&mut [R]; N],
    f: impl Fn(C::Item) -> [R; N],
) -> Result<(), Error> {
    check(&columns, &out)?;
    dispatched(
        #[inline(always)]
        || blocks(columns, &mut out, f),
    );
    Ok(())
}

/// Writes `f` of each element where that is a number, and `otherwise` where it is NaN: a formula in
/// lanes that knows where it does not serve, and one of branches for the rest.
pub(super) fn fill_or<C: Columns>(
    columns: C,
    out: &mut [f32],
    f: impl Fn(C::Item) -> f32,
    otherwise: impl Fn(C::Item) -> f32,
) -> Result<(), Error> {
    fill(
        columns,
        [&mut *out],
        #[inline(always)]
        |item| [f(item)],
    )?;
    for (k, value) in out.iter_mut().enumerate() {
        if value.is_nan() {
            *value = otherwise(columns.at(k));
        }
    }
    Ok(())
}

/// Writes `f` of each element, for formulas of branches, which do not become lanes.
pub(super) fn fill_one_by_one<C: Columns, R: Real, const N: usize>(
    columns: C,
    mut out: [&mut [R]; N],
    f: impl Fn(C::Item) -> [R; N],
) -> Result<(), Error> {
    check(&columns, &out)?;
    blocks(columns, &mut out, f);
    Ok(())
}

fn check<C: Columns, R, const N: usize>(columns: &C, out: &[&mut [R]; N]) -> Result<(), Error> {
    let length = out[0].len();
    for column in out {
        same_length(length, column.len())?;
    }
    columns.check(length)
}

#[inline(always)]
fn blocks<C: Columns, R: Real, const N: usize>(
    columns: C,
    out: &mut [&mut [R]; N],
    f: impl Fn(C::Item) -> [R; N],
) {
    let length = out[0].len();
    let mut block = [[R::ZERO; BLOCK]; N];
    let mut start = 0;
    while start < length {
        let count = (length - start).min(BLOCK);
        let part = columns.part(start, count);
        for k in 0..count {
            for (column, value) in block.iter_mut().zip(f(part.at(k))) {
                column[k] = value;
            }
        }
        for (out, column) in out.iter_mut().zip(&block) {
            out[start..][..count].copy_from_slice(&column[..count]);
        }
        start += count;
    }
}

/// Runs `work` compiled for what the machine has: a copy of it for each instruction set.
#[cfg(feature = "dispatch")]
#[inline(always)]
fn dispatched(work: impl FnOnce()) {
    pulp::Arch::new().dispatch(work);
}

/// Runs `work` compiled for the target.
#[cfg(not(feature = "dispatch"))]
#[inline(always)]
fn dispatched(work: impl FnOnce()) {
    work();
}
