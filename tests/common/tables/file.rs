//! One CSV of a quantity's inputs and expected outputs.

use super::number::{SMALLER, number};
use super::quantity::{Quantity, quantity_of};
use std::fs;
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
    /// The line of each row, counted from 1.
    pub(crate) lines: Vec<usize>,
}

/// What a directory has.
pub(crate) struct Directory {
    /// The tables of the directory, in alphabetical order.
    pub(crate) tables: Vec<(Table, &'static Quantity)>,
    /// Names of what else lies there, in alphabetical order; hidden files are left out.
    pub(crate) ignored: Vec<String>,
}

/// Reads every CSV of a directory, whatever the case of its ending.
///
/// Errors are one line that names the file, and the stem, or line, column and value.
pub(crate) fn read_directory(directory: &Path) -> Result<Directory, String> {
    let named = |error: std::io::Error| format!("{}: {error}", directory.display());
    if directory.is_file() {
        return Err(format!("{}: a file, not a directory of tables", directory.display()));
    }
    let (mut paths, mut ignored) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(directory).map_err(named)? {
        let path = entry.map_err(named)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_csv = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
        // Editors and systems leave hidden files such as `._ggx_d.csv` beside tables.
        if name.starts_with('.') {
            continue;
        }
        if is_csv && !path.is_dir() {
            paths.push(path);
        } else {
            ignored.push(if path.is_dir() { format!("{name}/") } else { name });
        }
    }
    paths.sort();
    ignored.sort();
    if paths.is_empty() {
        let others = match ignored.as_slice() {
            [] => "the directory is empty".to_owned(),
            [only] => format!("only {only}"),
            [first, ..] => format!("{} other files, the first {first}", ignored.len()),
        };
        return Err(format!("{}: no CSV tables: {others}", directory.display()));
    }
    let tables = paths.into_iter().map(read_table).collect::<Result<_, _>>()?;
    Ok(Directory { tables, ignored })
}

fn read_table(path: PathBuf) -> Result<(Table, &'static Quantity), String> {
    let named = |message: String| format!("{}: {message}", path.display());
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let quantity = quantity_of(&stem.to_ascii_lowercase())
        .ok_or_else(|| named(format!("unknown table stem `{}`", shown(&stem))))?;
    let text = fs::read(&path).map_err(|error| named(error.to_string()))?;
    let text = String::from_utf8(text).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        named(format!("line {}: not UTF-8 text", before.split(|&byte| byte == b'\n').count()))
    })?;
    let mut lines = lines(&text);
    let (line, header) = lines.next().ok_or_else(|| named("empty file".into()))?;
    let header = fields(header).map_err(|message| named(format!("line {line}: {message}")))?;
    let order =
        columns(&header, quantity).map_err(|message| named(format!("line {line}: {message}")))?;
    let (mut rows, mut places) = (Vec::new(), Vec::new());
    for (line, text) in lines {
        let row = row(text, &header, &order, quantity)
            .map_err(|message| named(format!("line {line} (row {}): {message}", rows.len() + 1)))?;
        rows.push(row);
        places.push(line);
    }
    Ok((Table { path, stem: quantity.stem.to_owned(), rows, lines: places }, quantity))
}

/// Lines with their numbers, but for blank ones and comments.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    // Line ends of `\r` alone are those of a file without the other one.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let lines = text.split(end).map(str::trim).enumerate().map(|(index, line)| (index + 1, line));
    lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
}

/// The fields of one line.
fn fields(line: &str) -> Result<csv::StringRecord, String> {
    if line.matches('"').count() % 2 == 1 {
        return Err("a quote has no end on its line".into());
    }
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    reader.read_record(&mut record).map_err(|error| error.to_string())?;
    Ok(record)
}

/// The numbers of one line in the order of the quantity.
fn row(
    line: &str,
    header: &csv::StringRecord,
    order: &[usize],
    quantity: &Quantity,
) -> Result<Vec<f64>, String> {
    let record = fields(line)?;
    if record.len() != header.len() {
        let hint = if record.len() > header.len() { "; is a comma a decimal point?" } else { "" };
        let (fields, columns) = (record.len(), header.len());
        return Err(format!("{fields} fields, and the header has {columns}{hint}"));
    }
    let number = |&place: &usize| {
        let (text, column) = (&record[place], &header[place]);
        match number(text) {
            // An expected value this small is 0 to any library; an input is another one.
            Err(SMALLER) if quantity.outputs.contains(&column) => Ok(0.0),
            number => {
                number.map_err(|reason| format!("column `{column}`: `{}` {reason}", shown(text)))
            }
        }
    };
    order.iter().map(number).collect()
}

/// The place of each column of the quantity in the header.
fn columns(header: &csv::StringRecord, quantity: &Quantity) -> Result<Vec<usize>, String> {
    for separator in [';', '\t'] {
        if header.len() == 1 && header[0].contains(separator) {
            let name = if separator == ';' { "semicolons" } else { "tabs" };
            return Err(format!("columns are separated by {name}, not by commas"));
        }
    }
    let wanted: Vec<&str> = quantity.inputs.iter().chain(quantity.outputs).copied().collect();
    if let Some(unknown) = header.iter().find(|column| !wanted.contains(column)) {
        return Err(format!("unknown column `{}`", shown(unknown)));
    }
    let place = |column: &&str| {
        let mut places = (0..header.len()).filter(|&place| &header[place] == *column);
        let first = places.next().ok_or_else(|| format!("missing column `{column}`"))?;
        match places.next() {
            Some(_) => Err(format!("column `{column}` appears twice")),
            None => Ok(first),
        }
    };
    wanted.iter().map(place).collect()
}

/// A value as a message shows it: on one line, its beginning.
fn shown(text: &str) -> String {
    let beginning: String = text.chars().take(40).flat_map(char::escape_debug).collect();
    if text.chars().count() > 40 { beginning + "..." } else { beginning }
}
