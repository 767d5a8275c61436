//! The types of numbers in a legacy VTK file.

use crate::ReadError;
use crate::scanner::Scanner;

/// A type of numbers, and how many bytes each takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Bit,
    Int(usize),
    Unsigned(usize),
    Float(usize),
}

impl Kind {
    /// Reads the name of a kind.
    pub(super) fn read(scanner: &mut Scanner<'_>) -> Result<Self, ReadError> {
        let word = scanner.word().unwrap_or_default().to_ascii_lowercase();
        Ok(match &word[..] {
            b"bit" => Self::Bit,
            b"char" | b"signed_char" => Self::Int(1),
            b"unsigned_char" => Self::Unsigned(1),
            b"short" => Self::Int(2),
            b"unsigned_short" => Self::Unsigned(2),
            b"int" => Self::Int(4),
            b"unsigned_int" => Self::Unsigned(4),
            b"long" | b"long_long" | b"vtkidtype" => Self::Int(8),
            b"unsigned_long" | b"unsigned_long_long" => Self::Unsigned(8),
            b"vtktypeint8" => Self::Int(1),
            b"vtktypeuint8" => Self::Unsigned(1),
            b"vtktypeint16" => Self::Int(2),
            b"vtktypeuint16" => Self::Unsigned(2),
            b"vtktypeint32" => Self::Int(4),
            b"vtktypeuint32" => Self::Unsigned(4),
            b"vtktypeint64" => Self::Int(8),
            b"vtktypeuint64" => Self::Unsigned(8),
            b"float" => Self::Float(4),
            b"double" => Self::Float(8),
            other => {
                let other = String::from_utf8_lossy(&other[..other.len().min(40)]).into_owned();
                return Err(scanner.problem(format!("{other:?} is not a type of numbers")));
            }
        })
    }

    pub(super) fn len(self) -> usize {
        match self {
            Self::Bit => 1,
            Self::Int(len) | Self::Unsigned(len) | Self::Float(len) => len,
        }
    }

    pub(super) fn is_whole(self) -> bool {
        matches!(self, Self::Int(_) | Self::Unsigned(_))
    }

    /// A number from its bytes, the greatest first.
    pub(super) fn whole(self, item: &[u8]) -> i64 {
        let bits = item.iter().fold(0_u64, |bits, &byte| (bits << 8) | u64::from(byte));
        let unused = 64 - 8 * item.len() as u32;
        match self {
            // One beyond the range of i64 is far beyond any count.
            Self::Unsigned(_) => i64::try_from(bits).unwrap_or(i64::MAX),
            _ => ((bits << unused) as i64) >> unused,
        }
    }

    pub(super) fn float(self, item: &[u8]) -> f64 {
        match (self, item) {
            (Self::Float(_), &[a, b, c, d]) => f32::from_be_bytes([a, b, c, d]).into(),
            (Self::Float(_), item) => item.try_into().map_or(f64::NAN, f64::from_be_bytes),
            (kind, item) => kind.whole(item) as f64,
        }
    }
}
