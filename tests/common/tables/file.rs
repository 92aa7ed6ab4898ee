//! One CSV of a quantity's inputs and expected outputs.

use super::quantity::{Quantity, quantity_of};
use std::path::{Path, PathBuf};

/// The rows of one file, columns in the order of its quantity: inputs, then outputs.
#[derive(Debug)]
pub(crate) struct Table {
    /// Where it was read.
    pub(crate) path: PathBuf,
    /// The file's stem, which names the quantity.
    pub(crate) stem: String,
    /// The numbers.
    pub(crate) rows: Vec<Vec<f64>>,
}

/// Reads every CSV of a directory, in alphabetical order.
///
/// Errors are one line that names the file, and the stem, column or row.
pub(crate) fn read_directory(directory: &Path) -> Result<Vec<(Table, &'static Quantity)>, String> {
    let entries = std::fs::read_dir(directory)
        .map_err(|error| format!("{}: {error}", directory.display()))?;
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(|error| format!("{}: {error}", directory.display()))?.path();
        if path.extension().is_some_and(|extension| extension == "csv") {
            paths.push(path);
        }
    }
    if paths.is_empty() {
        return Err(format!("{}: no CSV tables", directory.display()));
    }
    paths.sort();
    paths.into_iter().map(read_table).collect()
}

fn read_table(path: PathBuf) -> Result<(Table, &'static Quantity), String> {
    let named = |message: String| format!("{}: {message}", path.display());
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let quantity =
        quantity_of(&stem).ok_or_else(|| named(format!("unknown table stem `{stem}`")))?;
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_path(&path)
        .map_err(|error| named(error.to_string()))?;
    let header = reader.headers().map_err(|error| named(error.to_string()))?.clone();
    if header.is_empty() {
        return Err(named("empty file".into()));
    }
    let wanted: Vec<&str> = quantity.inputs.iter().chain(quantity.outputs).copied().collect();
    if let Some(unknown) = header.iter().find(|column| !wanted.contains(column)) {
        return Err(named(format!("unknown column `{unknown}`")));
    }
    let mut order = Vec::with_capacity(wanted.len());
    for column in wanted {
        let mut places = (0..header.len()).filter(|&place| header.get(place) == Some(column));
        order.push(places.next().ok_or_else(|| named(format!("missing column `{column}`")))?);
        if places.next().is_some() {
            return Err(named(format!("column `{column}` appears twice")));
        }
    }
    let mut rows = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(|error| named(error.to_string()))?;
        let number = |&place: &usize| {
            let text = record.get(place).unwrap_or_default();
            match text.parse::<f64>() {
                Ok(x) if x.is_finite() => Ok(x),
                _ => Err(named(format!(
                    "row {}: column `{}`: `{text}` is not a finite number",
                    index + 1,
                    &header[place]
                ))),
            }
        };
        rows.push(order.iter().map(number).collect::<Result<_, _>>()?);
    }
    Ok((Table { path, stem, rows }, quantity))
}
