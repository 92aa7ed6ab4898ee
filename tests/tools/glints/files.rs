//! What a run of examples/glints left in a folder: names, bytes, and pictures.

use super::command::names;
use png::{BitDepth, ColorType, Decoder};
use std::fs;
use std::io::Cursor;
use std::path::Path;

/// A PNG's pixels, three codes each.
pub(crate) struct Picture {
    pub(crate) size: [usize; 2],
    pub(crate) codes: Vec<u8>,
}

/// Reads a picture of 8 bits.
pub(crate) fn picture(path: &Path) -> Picture {
    let file = fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = Decoder::new(Cursor::new(file)).read_info().expect("a PNG");
    let mut codes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut codes).expect("pixels");
    assert_eq!((info.color_type, info.bit_depth), (ColorType::Rgb, BitDepth::Eight));
    Picture { size: [info.width as usize, info.height as usize], codes }
}

/// All files of a folder, with their bytes.
pub(crate) fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let read = |name: String| {
        let bytes = fs::read(folder.join(&name)).expect("a file");
        (name, bytes)
    };
    names(folder).into_iter().map(read).collect()
}
