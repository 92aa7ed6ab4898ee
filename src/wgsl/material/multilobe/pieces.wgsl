// A kernel in pieces, so short that two boxes along any axes stand in for each. Rust:
// src/material/multilobe/pieces.rs.

// Rust: `LONGEST`.
const LOBE_PIECES_LONGEST: f32 = 1.5;
// Rust: `REACH`.
const LOBE_PIECES_REACH: f32 = 5.657;
// Rust: `HALF_DIAGONAL`.
const LOBE_PIECES_HALF_DIAGONAL: f32 = 0.7072;
// Rust: `MOST`.
const LOBE_PIECES_MOST: i32 = 12;

// Rust: `Pieces`.
struct LobePieces {
    axis: vec2f,
    along: f32,
    across: f32,
    longest: f32,
    first: i32,
    last: i32,
}

// Rust: `Piece`.
struct LobePiece {
    offset: vec2f,
    share: f32,
    square: f32,
    more: f32,
    axis: vec2f,
}

// Rust: `Pieces::of`.
fn lobe_pieces_of(psd: LobePsd) -> LobePieces {
    let eigen = lobe_psd_eigen(psd);
    let along = sqrt(12.0 * eigen.major);
    let across = sqrt(12.0 * eigen.minor);
    let longest = lobe_max(across, LOBE_PIECES_LONGEST);
    let last = select(0, lobe_floor(0.5 * along / longest + 0.5), along > longest);
    return LobePieces(eigen.axis, along, across, longest, -last, last);
}

// Rust: `Pieces::folded`.
fn lobe_pieces_folded(pieces: LobePieces, place: vec2f) -> vec2f {
    let along = pieces.axis.x * place.x + pieces.axis.y * place.y;
    let across = pieces.axis.x * place.y - pieces.axis.y * place.x;
    if along < 0.0 || (along == 0.0 && across < 0.0) {
        return vec2f(-place.x, -place.y);
    }
    return place;
}

// Rust: `Pieces::around`.
fn lobe_pieces_around(pieces: LobePieces, place: vec2f) -> LobePieces {
    let along = pieces.axis.x * place.x + pieces.axis.y * place.y;
    let reach = (LOBE_PIECES_REACH + LOBE_PIECES_HALF_DIAGONAL * pieces.longest) / pieces.longest
        + 0.5;
    let middle = along / pieces.longest;
    let begin = -lobe_floor(reach + middle);
    let end = lobe_floor(reach - middle);
    let first = select(pieces.first, begin, begin > pieces.first);
    let bounded = select(pieces.last, end, end < pieces.last);
    let most = first + LOBE_PIECES_MOST - 1;
    let last = select(most, bounded, bounded < most);
    return LobePieces(pieces.axis, pieces.along, pieces.across, pieces.longest, first, last);
}

// Rust: `Pieces::piece`.
fn lobe_pieces_piece(pieces: LobePieces, k: i32) -> LobePiece {
    var midpoint = 0.0;
    var along = lobe_min(pieces.longest, pieces.along);
    if k != 0 {
        let number = f32(abs(k));
        let low = (number - 0.5) * pieces.longest;
        let high = lobe_min((number + 0.5) * pieces.longest, 0.5 * pieces.along);
        midpoint = select(0.5 * (low + high), -(0.5 * (low + high)), k < 0);
        along = lobe_max(high - low, 0.0);
    }
    let square = pieces.across * pieces.across;
    let share = select(1.0, along / pieces.along, pieces.along > pieces.longest);
    return LobePiece(
        vec2f(pieces.axis.x * midpoint, pieces.axis.y * midpoint), share,
        square, along * along - square, pieces.axis
    );
}

// Rust: `Pieces::piece_at`.
fn lobe_pieces_piece_at(pieces: LobePieces, u: f32) -> LobePiece {
    let place = (u - 0.5) * pieces.along / pieces.longest + 0.5;
    let k = lobe_floor(place);
    let from_first = select(pieces.first, k, k > pieces.first);
    return lobe_pieces_piece(pieces, select(pieces.last, from_first, from_first < pieces.last));
}

// Rust: `Piece::widths`.
fn lobe_pieces_widths(piece: LobePiece, turn: vec2f) -> vec2f {
    let c = piece.axis.x * turn.x + piece.axis.y * turn.y;
    let s = piece.axis.y * turn.x - piece.axis.x * turn.y;
    return vec2f(
        sqrt(lobe_max(piece.square + c * c * piece.more, 0.0)),
        sqrt(lobe_max(piece.square + s * s * piece.more, 0.0))
    );
}
