//! Whether a PNG file is whole: every chunk's checksum, the pixels' own checksum, and an end.
//!
//! A decoder that gives out rows stops at the last row, and may leave the checksum behind it
//! unread. Readers of pictures therefore ask this module first.

use png::{DecodeOptions, Decoded, DecodingError, StreamingDecoder, UnfilterRegion, chunk};

/// Bytes of the window into which pixels are inflated; the inflater looks back 32 KiB in it.
const WINDOW: usize = 1 << 17;

/// The number of bytes after the end chunk of a whole PNG, or how the file is damaged.
///
/// Refused: a file that ends early, by a single byte too; a wrong CRC of any chunk; pixels whose
/// Adler-32 sum is wrong or missing, those of an animation's frames too; a transparency chunk that
/// cannot be read, since it changes texels. Bytes after the end chunk belong to no picture: they
/// are counted, and the caller says so. Bytes after the pixels' sum within their chunks, and rows
/// beyond the header's height, are ignored without a word.
pub(crate) fn trailing(file: &[u8]) -> Result<usize, String> {
    let mut options = DecodeOptions::default();
    options.set_ignore_checksums(false);
    options.set_skip_ancillary_crc_failures(false);
    // Their bytes still enter the chunks' checksums.
    options.set_ignore_text_chunk(true);
    options.set_ignore_iccp_chunk(true);
    let mut decoder = StreamingDecoder::new_with_options(options);
    let mut window = vec![0; WINDOW];
    let mut region = UnfilterRegion::default();
    let mut place = 0;
    loop {
        if place == file.len() {
            return Err("not a readable PNG (the file ends too early)".to_owned());
        }
        // A window that is never full: the decoder takes a full one for the end of the pixels.
        if region.filled > WINDOW / 2 {
            window.copy_within(region.available..region.filled, 0);
            region.filled -= region.available;
            region.available = 0;
        }
        let update = decoder.update(&file[place..], Some(&mut region.as_buf(&mut window)));
        let (consumed, event) = update.map_err(broken)?;
        place += consumed;
        match event {
            Decoded::ChunkComplete(chunk::IEND) => return Ok(file.len() - place),
            Decoded::BadAncillaryChunk(chunk::tRNS) => {
                return Err("not a readable PNG (its transparency, tRNS, is malformed)".to_owned());
            }
            // The next frame of an animation has a stream of its own.
            Decoded::ImageDataFlushed => region = UnfilterRegion::default(),
            _ => {}
        }
    }
}

/// The line for what the decoder refuses: chunks by their names, without the decoder's notes on
/// them.
// By value: the shape that `map_err` takes.
#[allow(clippy::needless_pass_by_value)]
pub(crate) fn broken(error: DecodingError) -> String {
    const BEFORE: &str = "ChunkType { type: ";
    let text = error.to_string();
    let mut parts = text.split(BEFORE);
    let mut line = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(',').unwrap_or((part, ""));
        line = line + name + rest.split_once('}').map_or("", |(_, rest)| rest);
    }
    format!("not a readable PNG ({})", line.trim_end_matches('.'))
}
