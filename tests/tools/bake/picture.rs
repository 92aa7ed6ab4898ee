//! Pictures for the baker: by an encoder, and what encoders do not write.

use png::{BitDepth, ColorType};

/// A PNG by the encoder.
pub(crate) fn picture(
    [width, height]: [u32; 2],
    color: ColorType,
    depth: BitDepth,
    data: &[u8],
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Fastest);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![128, 128, 255]);
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(data).expect("pixels");
    writer.finish().expect("an end");
    file
}

/// Width and height of [`texels`].
pub(crate) const SIZE: [u32; 2] = [5, 3];

/// Normals of an odd-sized map, none alike: up, tilted, one below the horizon.
pub(crate) fn texels() -> Vec<[u8; 3]> {
    let number = |k: u32, factor: u32| 96 + (k * factor % 64) as u8;
    let mut texels: Vec<_> = (0..SIZE[0] * SIZE[1])
        .map(|k| [number(k, 37), number(k, 23), 246 + (5 * k % 9) as u8])
        .collect();
    texels[7] = [200, 90, 100];
    texels
}

/// Them as a PNG.
pub(crate) fn rgb(texels: &[[u8; 3]]) -> Vec<u8> {
    picture(SIZE, ColorType::Rgb, BitDepth::Eight, texels.as_flattened())
}

/// CRC-32 as PNG has it.
pub(crate) fn checksum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0, |sum, &byte| {
        (0..8).fold(sum ^ u32::from(byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

/// The same as Adam7 has it, which the encoder does not write: seven passes of every n-th texel.
pub(crate) fn interlaced(texels: &[[u8; 3]]) -> Vec<u8> {
    const PASSES: [[usize; 4]; 7] = [
        [0, 8, 0, 8],
        [4, 8, 0, 8],
        [0, 4, 4, 8],
        [2, 4, 0, 4],
        [0, 2, 2, 4],
        [1, 2, 0, 2],
        [0, 1, 1, 2],
    ];
    let [width, height] = SIZE.map(|n| n as usize);
    let mut data = Vec::new();
    for [column, columns, row, rows] in PASSES {
        // Passes without a column have no rows either.
        for row in (row..height).step_by(rows).filter(|_| column < width) {
            data.push(0);
            let line = (column..width).step_by(columns);
            data.extend(line.flat_map(|column| texels[row * width + column]));
        }
    }
    assembled(SIZE, ColorType::Rgb, BitDepth::Eight, true, &[(b"IDAT", zlib(&data))])
}

/// Bytes as one stored block of zlib, and their Adler-32 sum.
pub(crate) fn zlib(data: &[u8]) -> Vec<u8> {
    let length = u16::try_from(data.len()).expect("a small picture");
    let (a, b) = data.iter().fold((1, 0), |(a, b), &byte| {
        let a = (a + u32::from(byte)) % 65521;
        (a, (b + a) % 65521)
    });
    let [low, high] = length.to_le_bytes();
    let head = [0x78, 1, 1, low, high, !low, !high];
    [&head[..], data, &(b << 16 | a).to_be_bytes()].concat()
}

/// Rows as PNG filters none of them: each after a zero.
pub(crate) fn filtered(data: &[u8], height: u32) -> Vec<u8> {
    let rows = data.chunks_exact(data.len() / height as usize);
    rows.flat_map(|row| [&[0], row].concat()).collect()
}

/// A PNG of these chunks, between its header and its end.
pub(crate) fn assembled(
    [width, height]: [u32; 2],
    color: ColorType,
    depth: BitDepth,
    interlaced: bool,
    chunks: &[(&[u8; 4], Vec<u8>)],
) -> Vec<u8> {
    let kind = [depth as u8, color as u8, 0, 0, u8::from(interlaced)];
    let header = [&width.to_be_bytes()[..], &height.to_be_bytes(), &kind].concat();
    let chunk = |name: &[u8; 4], data: &[u8]| {
        let body = [name, data].concat();
        let length = (data.len() as u32).to_be_bytes();
        [&length[..], &body, &checksum(&body).to_be_bytes()].concat()
    };
    let middle: Vec<u8> = chunks.iter().flat_map(|(name, data)| chunk(name, data)).collect();
    [&b"\x89PNG\r\n\x1a\n"[..], &chunk(b"IHDR", &header), &middle, &chunk(b"IEND", &[])].concat()
}
