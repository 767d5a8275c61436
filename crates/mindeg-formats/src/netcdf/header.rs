//! The header of a file in classic NetCDF: dimensions, attributes and variables.

use std::ops::Range;

use crate::ReadError;

/// The numbers with which the lists of a header begin.
pub(super) const DIMENSIONS: u32 = 10;
pub(super) const VARIABLES: u32 = 11;
pub(super) const ATTRIBUTES: u32 = 12;

/// The type of numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    I8,
    Text,
    I16,
    I32,
    F32,
    F64,
    U8,
    U16,
    U32,
    I64,
    U64,
}

/// `NC_FILL_FLOAT` and `NC_FILL_DOUBLE`: 15 * 2^119.
const FILL: f64 = 15.0 * (1_u128 << 119) as f64;

impl Kind {
    fn of(number: u32) -> Option<Self> {
        const ALL: [Kind; 11] = [
            Kind::I8,
            Kind::Text,
            Kind::I16,
            Kind::I32,
            Kind::F32,
            Kind::F64,
            Kind::U8,
            Kind::U16,
            Kind::U32,
            Kind::I64,
            Kind::U64,
        ];
        ALL.get(number.checked_sub(1)? as usize).copied()
    }

    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 | Self::Text => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 | Self::I64 | Self::U64 => 8,
        }
    }

    /// What stands for no value where a variable names nothing else: NetCDF's own, but of bytes, which have all their values.
    pub(super) fn fill(self) -> Option<f64> {
        Some(match self {
            Self::I16 => -32_767.0,
            Self::I32 => -2_147_483_647.0,
            Self::F32 | Self::F64 => FILL,
            _ => return None,
        })
    }

    /// The number in its bytes, of which there are as many as it has.
    pub(super) fn number(self, bytes: &[u8]) -> f64 {
        fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
            std::array::from_fn(|index| bytes.get(index).copied().unwrap_or_default())
        }
        match self {
            Self::I8 => i8::from_be_bytes(array(bytes)).into(),
            Self::U8 | Self::Text => u8::from_be_bytes(array(bytes)).into(),
            Self::I16 => i16::from_be_bytes(array(bytes)).into(),
            Self::U16 => u16::from_be_bytes(array(bytes)).into(),
            Self::I32 => i32::from_be_bytes(array(bytes)).into(),
            Self::U32 => u32::from_be_bytes(array(bytes)).into(),
            Self::F32 => f32::from_be_bytes(array(bytes)).into(),
            Self::F64 => f64::from_be_bytes(array(bytes)),
            Self::I64 => i64::from_be_bytes(array(bytes)) as f64,
            Self::U64 => u64::from_be_bytes(array(bytes)) as f64,
        }
    }
}

/// An attribute: its numbers, or its text.
struct Attribute<'a> {
    name: String,
    kind: Kind,
    bytes: &'a [u8],
}

pub(super) struct Variable<'a> {
    pub(super) name: String,
    /// Indices of dimensions.
    pub(super) dimensions: Vec<usize>,
    attributes: Vec<Attribute<'a>>,
    pub(super) kind: Kind,
    pub(super) begin: usize,
}

impl Variable<'_> {
    pub(super) fn number(&self, attribute: &str) -> Option<f64> {
        let found = self.attributes.iter().find(|own| own.name == attribute)?;
        let is_one = found.kind != Kind::Text && found.bytes.len() == found.kind.bytes();
        is_one.then(|| found.kind.number(found.bytes))
    }

    fn text(&self, attribute: &str) -> String {
        let found = self.attributes.iter().find(|own| own.name == attribute);
        found.map_or(String::new(), |own| String::from_utf8_lossy(own.bytes).to_ascii_lowercase())
    }

    /// Whether it is a coordinate of the axis, by its attributes or its name: x and east, or y and north.
    pub(super) fn is_along(&self, axis: &str, degrees: &str, names: [&str; 2]) -> bool {
        let name = self.name.to_ascii_lowercase();
        self.text("axis") == axis
            || self.text("units").contains(degrees)
            || names.into_iter().any(|start| name.starts_with(start))
    }
}

/// The header of a file, from front to back.
struct Header<'a> {
    file: &'a [u8],
    at: usize,
    version: u8,
}

impl<'a> Header<'a> {
    fn problem(&self, problem: &str) -> ReadError {
        ReadError::byte(self.at, problem)
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        let bytes = self.file.get(self.at..).and_then(|rest| rest.get(..count));
        let bytes = bytes.ok_or_else(|| self.problem("the file ends within the header"))?;
        self.at += count;
        Ok(bytes)
    }

    fn word(&mut self) -> Result<u32, ReadError> {
        Ok(Kind::U32.number(self.take(4)?) as u32)
    }

    fn long(&mut self) -> Result<usize, ReadError> {
        let bytes = self.take(8)?;
        let value = bytes.iter().fold(0_u64, |value, byte| value << 8 | u64::from(*byte));
        usize::try_from(value).map_err(|_| self.problem("this number is too large"))
    }

    /// A count, or a length.
    fn count(&mut self) -> Result<usize, ReadError> {
        if self.version == 5 { self.long() } else { Ok(self.word()? as usize) }
    }

    /// Bytes, and those that fill them up to four.
    fn padded(&mut self, count: usize) -> Result<&'a [u8], ReadError> {
        let bytes = self.take(count)?;
        self.take((4 - count % 4) % 4)?;
        Ok(bytes)
    }

    fn name(&mut self) -> Result<String, ReadError> {
        let count = self.count()?;
        Ok(String::from_utf8_lossy(self.padded(count)?).into_owned())
    }

    /// The number of items of a list.
    fn list(&mut self, tag: u32) -> Result<Range<usize>, ReadError> {
        let found = self.word()?;
        let count = self.count()?;
        match (found, count) {
            (0, 0) => Ok(0..0),
            (found, count) if found == tag => Ok(0..count),
            _ => Err(self.problem("this is no list of a NetCDF header")),
        }
    }

    fn kind(&mut self) -> Result<Kind, ReadError> {
        let kind = Kind::of(self.word()?);
        kind.ok_or_else(|| self.problem("this type of numbers is not known"))
    }

    fn attributes(&mut self) -> Result<Vec<Attribute<'a>>, ReadError> {
        let mut all = Vec::new();
        for _ in self.list(ATTRIBUTES)? {
            let (name, kind, count) = (self.name()?, self.kind()?, self.count()?);
            let bytes = count.checked_mul(kind.bytes());
            let bytes = bytes.ok_or_else(|| self.problem("this count is too large"))?;
            all.push(Attribute { name, kind, bytes: self.padded(bytes)? });
        }
        Ok(all)
    }
}

/// A file with its header read.
pub(super) struct Dataset<'a> {
    pub(super) file: &'a [u8],
    /// Names and lengths; one dimension may be that of the records.
    pub(super) dimensions: Vec<(String, usize)>,
    pub(super) of_records: Option<usize>,
    /// The bytes from one record to the next.
    pub(super) record: usize,
    pub(super) variables: Vec<Variable<'a>>,
}

impl<'a> Dataset<'a> {
    pub(super) fn read(file: &'a [u8]) -> Result<Self, ReadError> {
        let version = file.get(3).copied().unwrap_or_default();
        let mut header = Header { file, at: 4, version };
        let records = header.count()?;
        let mut dimensions = Vec::new();
        let mut of_records = None;
        for index in header.list(DIMENSIONS)? {
            let (name, length) = (header.name()?, header.count()?);
            if length == 0 {
                of_records = Some(index);
            }
            dimensions.push((name, if length == 0 { records } else { length }));
        }
        header.attributes()?;
        let mut variables: Vec<Variable<'a>> = Vec::new();
        let mut records = Vec::new();
        for _ in header.list(VARIABLES)? {
            let name = header.name()?;
            let mut own = Vec::new();
            for _ in 0..header.count()? {
                let index = header.count()?;
                if index >= dimensions.len() {
                    return Err(header.problem("there is no such dimension"));
                }
                own.push(index);
            }
            let (attributes, kind, size) = (header.attributes()?, header.kind()?, header.count()?);
            let begin = if version == 1 { header.word()? as usize } else { header.long()? };
            if own.first().is_some_and(|first| Some(*first) == of_records) {
                let values = own[1..].iter().try_fold(kind.bytes(), |bytes, dimension| {
                    bytes.checked_mul(dimensions[*dimension].1)
                });
                records.push((size, values.unwrap_or(size)));
            }
            variables.push(Variable { name, dimensions: own, attributes, kind, begin });
        }
        let record = match records[..] {
            // A single variable of records is not filled up to four bytes.
            [(_, values)] => values,
            _ => records.iter().fold(0, |sum: usize, (size, _)| sum.saturating_add(*size)),
        };
        Ok(Self { file, dimensions, of_records, record, variables })
    }
}
