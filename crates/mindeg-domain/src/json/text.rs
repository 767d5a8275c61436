//! A valid JSON text: where its values are.
//!
//! serde_json checks the syntax first. So this reader meets only valid JSON, and treats commas and
//! colons as space.

use serde::de::IgnoredAny;

use super::error::DomainJsonError;
use super::fault::{Fault, shortened};
use super::syntax;
use crate::error::{DomainError, Place, Step};

/// The text without the mark that some Windows programs put first, if it is JSON.
pub(super) fn checked(text: &str) -> Result<&str, DomainJsonError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match serde_json::from_str::<IgnoredAny>(text) {
        Ok(_) => Ok(text),
        Err(error) => Err(syntax::no_json(text, &error)),
    }
}

/// Whether a text is JSON with a value at this place.
pub(super) fn has(text: &str, place: &Place) -> bool {
    checked(text).is_ok_and(|text| Reader { text, at: 0 }.find(&place.0).is_some())
}

/// An error in a description, with the line and column of the value that it is about.
pub(super) fn located(text: &str, error: DomainError) -> DomainJsonError {
    /// Each fault is looked for from the start of the text: some seconds for all of them.
    const MOST_BYTES: usize = 1_000_000_000;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let DomainError { mut place, message, more, .. } = error;
    let found = MOST_BYTES / text.len().max(1);
    let more: Vec<_> = more.into_iter().take(found).map(|error| located(text, error)).collect();
    loop {
        let find = |place: &Place| Reader { text, at: 0 }.find(&place.0);
        let found = place.given().into_iter().find_map(|place| Some((find(&place)?, place)));
        if let Some((start, place)) = found {
            return DomainJsonError { more, ..at(text, start, &place, message) };
        }
        // The wrong value was left out: report the value that should contain it.
        place.0.pop();
    }
}

pub(super) fn at(text: &str, start: usize, place: &Place, message: String) -> DomainJsonError {
    let before = &text[..start];
    let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
    let column = start - before.rfind('\n').map_or(0, |end| end + 1) + 1;
    DomainJsonError { path: place.to_string(), line, column, message, more: Vec::new() }
}

/// A valid JSON text, from some position on.
pub(super) struct Reader<'t> {
    pub(super) text: &'t str,
    pub(super) at: usize,
}

impl<'t> Reader<'t> {
    /// The first byte of the next value, or the end of the list or object.
    pub(super) fn peek(&mut self) -> u8 {
        let rest = self.text[self.at..].trim_start_matches([' ', '\t', '\n', '\r', ',', ':']);
        self.at = self.text.len() - rest.len();
        rest.bytes().next().unwrap_or(b'}')
    }

    /// The next value if it is a string, number, boolean or null.
    pub(super) fn token(&mut self) -> &'t str {
        let is_text = self.peek() == b'"';
        let rest = &self.text[self.at..];
        let mut is_escaped = false;
        let ends = |(at, byte): (usize, u8)| match byte {
            b'"' if is_text && at > 0 && !is_escaped => Some(at + 1),
            b',' | b']' | b'}' | b' ' | b'\t' | b'\n' | b'\r' if !is_text => Some(at),
            _ => {
                is_escaped = byte == b'\\' && !is_escaped;
                None
            }
        };
        let len = rest.bytes().enumerate().find_map(ends).unwrap_or(rest.len());
        self.at += len;
        &rest[..len]
    }

    /// The next value, or key, as a string.
    pub(super) fn string(&mut self) -> Result<String, Fault> {
        let start = self.at;
        let token = self.token();
        serde_json::from_str(token).map_err(|_| Fault {
            at: Some(start),
            ..Fault::new("this text has an escape that is no character".to_owned())
        })
    }

    /// Passes a value.
    pub(super) fn skip(&mut self) {
        match self.peek() {
            b'{' | b'[' => {
                self.at += 1;
                while !matches!(self.peek(), b'}' | b']') {
                    self.skip();
                }
                self.at += 1;
            }
            _ => _ = self.token(),
        }
    }

    /// The position of a value inside the next value.
    pub(super) fn find(&mut self, steps: &[Step]) -> Option<usize> {
        let first = self.peek();
        let Some((step, rest)) = steps.split_first() else { return Some(self.at) };
        self.at += 1;
        match (step, first) {
            (Step::Index(index), b'[') => {
                for _ in 0..*index {
                    self.item()?;
                    self.skip();
                }
                self.item()?;
                self.find(rest)
            }
            (Step::Key(wanted), b'{') => {
                while self.item().is_some() {
                    if self.string().is_ok_and(|key| key == *wanted) {
                        return self.find(rest);
                    }
                    self.skip();
                }
                None
            }
            _ => None,
        }
    }

    /// Whether the list or object goes on.
    pub(super) fn item(&mut self) -> Option<()> {
        (!matches!(self.peek(), b'}' | b']')).then_some(())
    }

    /// The next value, in the words of a message.
    pub(super) fn found(&mut self) -> String {
        match self.peek() {
            b'{' => "an object".to_owned(),
            b'[' => {
                let mut values = serde_json::Deserializer::from_str(&self.text[self.at..])
                    .into_iter::<Vec<IgnoredAny>>();
                let count = values.next().and_then(Result::ok).map_or(0, |items| items.len());
                format!("a list of {count} value{}", if count == 1 { "" } else { "s" })
            }
            b'"' => format!("the text {}", shortened(self.token())),
            b't' | b'f' | b'n' => self.token().to_owned(),
            _ => format!("the number {}", shortened(self.token())),
        }
    }
}

impl Place {
    /// The places where a text may give this value, the likeliest first.
    fn given(&self) -> Vec<Self> {
        let (ring, steps) = match &self.0[..] {
            [Step::Key(holes), Step::Index(hole), steps @ ..] if holes == "holes" => {
                (hole + 1, steps)
            }
            steps => (0, steps),
        };
        let side = |key: &str| {
            let side = self.0.len() - steps.len() + 2;
            Self(self.0[..side].to_vec()).then(key)
        };
        let of_ring = |key: &str| Self::ring(ring).then(key);
        let mut places = vec![self.clone()];
        match steps {
            [Step::Key(key), .., Step::Index(corner)] if key == "polygon" || key == "corners" => {
                places.extend([of_ring("ring").then(*corner), Self::key("rectangle")]);
            }
            [Step::Key(key), ..] if key == "polygon" || key == "corners" => {
                places.push(of_ring("ring"));
            }
            [_, _, Step::Key(key)] if key == "intervals" || key == "size" => {
                places.extend([side("size"), of_ring("size"), Self::key("size")]);
            }
            [_, _, Step::Key(key)] if key == "points" => {
                places.extend(["polyline", "arc", "bezier"].map(side));
                places.push(of_ring("ring"));
            }
            [_, _, Step::Key(key), Step::Index(point)] if key == "points" => {
                places.push(of_ring("ring").then(point + 1));
            }
            // One value for all sides describes each of them.
            [Step::Key(key)] if key == "sides" && ring == 0 => {
                places.extend(["polygon", "rectangle"].map(Self::key));
            }
            _ => {}
        }
        places
    }
}
