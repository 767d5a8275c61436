//! Well-known text: `POLYGON`, `MULTIPOLYGON` and `GEOMETRYCOLLECTION`, one or more in a file.
//!
//! A code of EPSG before a geometry (`SRID=32635;`) is the reference system of all. Z and M values are left out; points and
//! lines are those inside polygons.
//!
//! The crate `wkt` reads one geometry, without a reference system, recurses as deep as the text says, and
//! gives no position in its errors.

use std::collections::BTreeMap;

use glam::DVec2;
use mindeg_domain::Projection;

use super::outline::{DrawnRing, Feature, Outlines};
use super::text::{counted_all, number, quoted, text_of};
use crate::error::OutlineError;

/// How deep collections may be in each other.
const DEEPEST: u32 = 64;

/// Reads a text of one or more geometries.
///
/// # Errors
///
/// Malformed text, with the line and the column.
pub(super) fn read(bytes: &[u8]) -> Result<Outlines, OutlineError> {
    let text = text_of(bytes)?;
    let mut reader = Reader {
        text,
        at: 0,
        skipped: BTreeMap::new(),
        heights: false,
        srid: None,
        reaches: DVec2::ZERO,
        outlines: Outlines::default(),
    };
    reader.skip_separators();
    while reader.at < text.len() {
        reader.geometry(0)?;
        reader.skip_separators();
    }
    reader.end()
}

struct Reader<'a> {
    text: &'a str,
    /// The offset of the next byte.
    at: usize,
    skipped: BTreeMap<&'static str, usize>,
    heights: bool,
    /// The code of the reference system, as the text has it.
    srid: Option<&'a str>,
    /// The largest absolute values of the first and the second coordinate.
    reaches: DVec2,
    outlines: Outlines,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn skip_blanks(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// Between geometries: also what separates rows of a table.
    fn skip_separators(&mut self) {
        let is_separator = |c: char| c.is_whitespace() || matches!(c, ';' | ',' | '"');
        self.at = self.text.len() - self.rest().trim_start_matches(is_separator).len();
    }

    fn error_at(&self, at: usize, problem: impl Into<String>) -> OutlineError {
        let before = &self.text[..at];
        let line = 1 + before.matches('\n').count();
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        let column = 1 + before[start..].chars().count();
        OutlineError::place(format!("line {line}, column {column}"), problem)
    }

    fn unexpected(&self, expected: &str) -> OutlineError {
        let rest = self.rest();
        let found = match rest.split([' ', '\t', '\n', '\r']).next().unwrap_or_default() {
            "" => "the end of the text".to_owned(),
            word => quoted(word),
        };
        self.error_at(self.at, format!("found {found}, expected {expected}"))
    }

    /// Whether the next character is this one, which is then passed over.
    fn takes(&mut self, wanted: char) -> bool {
        self.skip_blanks();
        let found = self.rest().starts_with(wanted);
        if found {
            self.at += wanted.len_utf8();
        }
        found
    }

    /// Letters and digits.
    fn word(&mut self) -> &'a str {
        self.skip_blanks();
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn geometry(&mut self, depth: u32) -> Result<(), OutlineError> {
        let start = self.at;
        let mut keyword = self.word().to_ascii_uppercase();
        if keyword == "SRID" {
            self.srid(start)?;
            keyword = self.word().to_ascii_uppercase();
        }
        // The mark of the dimensions may stand apart, or be written together with the keyword.
        let known = |keyword: &str| KEYWORDS.into_iter().find(|known| *known == keyword);
        let bare = keyword.trim_end_matches(['Z', 'M']);
        let Some(keyword) = known(&keyword).or_else(|| known(bare)) else {
            self.at = start;
            return Err(self.unexpected("POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION"));
        };
        let before = self.at;
        let word = self.word().to_ascii_uppercase();
        let is_empty = match word.as_str() {
            "Z" | "M" | "ZM" => {
                let before = self.at;
                let is_empty = self.word().eq_ignore_ascii_case("EMPTY");
                if !is_empty {
                    self.at = before;
                }
                is_empty
            }
            "EMPTY" => true,
            _ => {
                self.at = before;
                false
            }
        };
        if is_empty {
            *self.skipped.entry("empty geometry").or_default() += 1;
            return Ok(());
        }
        match keyword {
            "POLYGON" | "MULTIPOLYGON" => {
                if keyword == "POLYGON" { self.polygon() } else { self.listed(Self::polygon) }?;
                self.outlines.end_shape();
                Ok(())
            }
            "GEOMETRYCOLLECTION" if depth == DEEPEST => Err(self.error_at(
                start,
                format!("collections lie more than {DEEPEST} deep in each other"),
            )),
            "GEOMETRYCOLLECTION" => self.listed(|reader| {
                reader.skip_blanks();
                reader.geometry(depth + 1)
            }),
            "LINESTRING" => self.line(),
            "MULTILINESTRING" => self.listed(Self::line),
            // The points of a MULTIPOINT may each be in parentheses.
            _ => self.listed(|reader| {
                let is_nested = reader.takes('(');
                let at = reader.point()?;
                reader.outlines.inside.add_point(at, None);
                if is_nested && !reader.takes(')') {
                    return Err(reader.unexpected("\")\""));
                }
                Ok(())
            }),
        }
    }

    /// The rest of `SRID=32635;`, which began at `start`.
    fn srid(&mut self, start: usize) -> Result<(), OutlineError> {
        let end = self.rest().find(';').ok_or_else(|| self.unexpected("\";\" after SRID=…"))?;
        let code = self.rest()[..end].trim_start_matches('=').trim();
        if let Some(other) = self.srid.replace(code).filter(|other| *other != code) {
            let [other, code] = [other, code].map(quoted);
            let problem = format!("found the SRID {code} after {other}; give all one SRID");
            return Err(self.error_at(start, problem));
        }
        self.at += end + 1;
        Ok(())
    }

    /// A list in parentheses, with commas between.
    fn listed(
        &mut self,
        mut item: impl FnMut(&mut Self) -> Result<(), OutlineError>,
    ) -> Result<(), OutlineError> {
        if !self.takes('(') {
            return Err(self.unexpected("\"(\""));
        }
        loop {
            item(self)?;
            if self.takes(')') {
                return Ok(());
            }
            if !self.takes(',') {
                return Err(self.unexpected("\",\" or \")\""));
            }
        }
    }

    fn polygon(&mut self) -> Result<(), OutlineError> {
        let mut rings = Vec::new();
        self.listed(|reader| {
            let mut points = Vec::new();
            reader.listed(|reader| {
                points.push(reader.point()?);
                Ok(())
            })?;
            rings.push(DrawnRing::of_points(points));
            Ok(())
        })?;
        self.outlines.features.push(Feature { rings, ..Feature::default() });
        Ok(())
    }

    fn line(&mut self) -> Result<(), OutlineError> {
        let mut points = Vec::new();
        self.listed(|reader| {
            points.push(reader.point()?);
            Ok(())
        })?;
        self.outlines.inside.add_line(&points, None);
        Ok(())
    }

    fn point(&mut self) -> Result<DVec2, OutlineError> {
        let point = DVec2::new(self.number()?, self.number()?);
        self.reaches = self.reaches.max(point.abs());
        for _ in 0..2 {
            self.skip_blanks();
            if !self.rest().starts_with([',', ')']) {
                self.number()?;
                self.heights = true;
            }
        }
        Ok(point)
    }

    fn number(&mut self) -> Result<f64, OutlineError> {
        self.skip_blanks();
        let rest = self.rest();
        let end = rest.find(|c: char| c.is_whitespace() || matches!(c, ',' | '(' | ')'));
        let word = &rest[..end.unwrap_or(rest.len())];
        let number = number(word).ok_or_else(|| self.unexpected("a finite number"))?;
        self.at += word.len();
        Ok(number)
    }

    fn end(mut self) -> Result<Outlines, OutlineError> {
        let skipped = counted_all(&self.skipped);
        if self.outlines.features.is_empty() {
            let only = match &*skipped {
                _ if !self.outlines.inside.is_empty() => "only lines or points".to_owned(),
                "" => "the text is empty".to_owned(),
                skipped => format!("only {skipped}"),
            };
            return Err(OutlineError::place("", format!("no POLYGON or MULTIPOLYGON: {only}")));
        }
        let notes = &mut self.outlines.notes;
        if !skipped.is_empty() {
            notes.push(format!("left out {skipped}"));
        }
        if self.heights {
            notes.push("left out the Z and M values of points".to_owned());
        }
        self.outlines.inside.drop_repeated_points();
        // PostGIS writes 0 where there is none.
        if let Some(srid) = self.srid.filter(|srid| *srid != "0") {
            let is_in_degrees = self.reaches.cmplt(DVec2::new(180.0 + 1e-9, 90.0 + 1e-9)).all();
            let name = format!("EPSG:{srid}");
            self.outlines.take_reference_system("SRID", &name, is_in_degrees);
            let is_of_degrees = srid.parse().is_ok_and(Projection::is_of_degrees);
            self.outlines.is_geographic = is_in_degrees && is_of_degrees;
        }
        Ok(self.outlines)
    }
}

const KEYWORDS: [&str; 7] = [
    "POLYGON",
    "MULTIPOLYGON",
    "GEOMETRYCOLLECTION",
    "POINT",
    "MULTIPOINT",
    "LINESTRING",
    "MULTILINESTRING",
];

/// Whether a text begins as well-known text does.
pub(super) fn begins(text: &str) -> bool {
    let start: String = text.chars().take(24).collect::<String>().to_ascii_uppercase();
    KEYWORDS.into_iter().chain(["SRID="]).any(|keyword| start.starts_with(keyword))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Outlines, String> {
        super::read(text.as_bytes()).map_err(|error| error.to_string())
    }

    fn ring(points: &[[f64; 2]]) -> DrawnRing {
        DrawnRing::of_points(points.iter().copied().map(DVec2::from))
    }

    #[test]
    fn reads_polygons_in_all_their_spellings() {
        let a = ring(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]]);
        let b = ring(&[[1.0, 1.0], [1.5, 1.0], [1.0, 1.25e-3]]);
        for (text, expected) in [
            ("POLYGON ((0 0, 4 0, 0 3, 0 0))", &[&[&a][..]][..]),
            ("polygon((0 0,4 0,0 3))", &[&[&a]]),
            ("SRID=4326;POLYGON((0 0,4 0,0 3),(1 1,1.5 1,1 1.25e-3))", &[&[&a, &b]]),
            ("MULTIPOLYGON(((0 0,4 0,0 3)),((1 1,1.5 1,1 1.25e-3)))", &[&[&a], &[&b]]),
            ("POLYGON((0 0,4 0,0 3))\nPOLYGON((1 1,1.5 1,1 1.25e-3))\n", &[&[&a], &[&b]]),
            (
                "GEOMETRYCOLLECTION ( GEOMETRYCOLLECTION(POLYGON((0 0,4 0,0 3))), POLYGON((1 1,1.5 1,1 1.25e-3)))",
                &[&[&a], &[&b]],
            ),
        ] {
            let outlines = read(text).unwrap();
            let found: Vec<Vec<&DrawnRing>> =
                outlines.features.iter().map(|feature| feature.rings.iter().collect()).collect();
            assert_eq!(found, expected, "{text}");
            assert!(outlines.notes.is_empty());
        }
    }

    #[test]
    fn what_is_left_out_is_said() {
        for (text, notes) in [
            ("POLYGON Z ((0 0 1, 4 0 1, 0 3 1))", &["left out the Z and M values of points"][..]),
            ("POLYGONZM((0 0 1 2, 4 0 1 2, 0 3 1 2))", &["left out the Z and M values of points"]),
            (
                "GEOMETRYCOLLECTION(POINT(1 2), MULTIPOINT((1 2), (3 4)), POLYGON EMPTY, POLYGON((0 0,4 0,0 3)))",
                &["left out 1 empty geometry"],
            ),
            (
                "POLYGON((0 0,4 0,0 3)) LINESTRING Z (1 1 0,2 1 0) MULTILINESTRING((1 1,1 2),(1 2,2 1)) MULTIPOINT(1.5 1, 1 1.5)",
                &["left out the Z and M values of points"],
            ),
        ] {
            let outlines = read(text).unwrap();
            assert_eq!(
                (outlines.features.len(), &outlines.notes[..]),
                (1, notes.map_strings().as_slice()),
                "{text}"
            );
        }
    }

    /// The code was passed over, so that the places of a file in metres had no degrees.
    #[test]
    fn a_code_before_a_geometry_is_its_reference_system() {
        let metres = "POLYGON((200000 4200000,300000 4200000,200000 4300000))";
        let degrees = "POLYGON((24 38,25 38,24 39))";
        for (text, zone, is_geographic, note) in [
            (
                format!("SRID=32635;{metres}"),
                Some("UTM zone 35 north"),
                false,
                Some("its SRID is EPSG:32635: metres, by"),
            ),
            (format!("SRID=4326;{degrees}"), None, true, None),
            (format!("SRID=0;{degrees}"), None, false, None),
            (
                format!("SRID=2100;{metres}"),
                None,
                false,
                Some("its SRID is EPSG:2100, which is not known here"),
            ),
            (
                format!("SRID=x;{metres}"),
                None,
                false,
                Some("its SRID is \"EPSG:x\", which is not known here"),
            ),
            (
                format!("SRID=32635;{degrees}"),
                None,
                false,
                Some("but the coordinates are within those of degrees"),
            ),
        ] {
            let outlines = read(&text).unwrap();
            let name = outlines.projection.map(|projection| projection.name());
            assert_eq!((name.as_deref(), outlines.is_geographic), (zone, is_geographic), "{text}");
            assert_eq!(outlines.notes.len(), usize::from(note.is_some()), "{text}");
            assert!(outlines.notes.iter().all(|told| note.is_some_and(|it| told.contains(it))));
        }
        let two = format!("SRID=32635;{metres}\nSRID=32634;{metres}");
        let told = "line 2, column 1: found the SRID \"32634\" after \"32635\"; give all one SRID";
        assert_eq!(read(&two).unwrap_err(), told);
    }

    trait Strings {
        fn map_strings(&self) -> Vec<String>;
    }

    impl Strings for [&str] {
        fn map_strings(&self) -> Vec<String> {
            self.iter().map(|&text| text.to_owned()).collect()
        }
    }

    #[test]
    fn errors_say_where_and_what() {
        for (text, message) in [
            ("", "no POLYGON or MULTIPOLYGON: the text is empty"),
            ("POINT(1 2)", "no POLYGON or MULTIPOLYGON: only lines or points"),
            ("POLYGON((0 0, 1 é))", "line 1, column 17: found \"é))\", expected a finite number"),
            (
                "POLYGON((0 0, 1 nan))",
                "line 1, column 17: found \"nan))\", expected a finite number",
            ),
            ("POLYGON((0 0\n, 1))", "line 2, column 4: found \"))\", expected a finite number"),
            (
                "POLYGON((0 0, 1 1",
                "line 1, column 18: found the end of the text, expected a finite number",
            ),
            ("POLYGON((0 0 1 2 3))", "line 1, column 18: found \"3))\", expected \",\" or \")\""),
            ("POLYGON (0 0, 1 1)", "line 1, column 10: found \"0\", expected \"(\""),
            (
                "POLY((0 0))",
                "line 1, column 1: found \"POLY((0\", expected POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION",
            ),
            ("LINESTRING(0 0, (1 1)", "line 1, column 17: found \"(1\", expected a finite number"),
            (
                "LINESTRING(0 0, 1 1",
                "line 1, column 20: found the end of the text, expected a finite number",
            ),
            ("SRID=4326", "line 1, column 5: found \"=4326\", expected \";\" after SRID=…"),
        ] {
            assert_eq!(read(text).unwrap_err(), message, "{text}");
        }
        let deep = "GEOMETRYCOLLECTION(".repeat(100_000);
        assert!(read(&deep).unwrap_err().ends_with("more than 64 deep in each other"));
    }
}
