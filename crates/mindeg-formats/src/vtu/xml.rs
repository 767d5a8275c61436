//! The elements of an XML file, one at a time, as far as VTU has them.

use crate::ReadError;

/// The start or the end of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tag<'a> {
    pub(super) name: &'a [u8],
    pub(super) is_end: bool,
    /// Whether it is start and end in one.
    pub(super) is_empty: bool,
    attributes: &'a [u8],
    /// Where the tag begins in the file, and where it ends.
    pub(super) start: usize,
    pub(super) end: usize,
}

impl<'a> Tag<'a> {
    /// The value of an attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&'a str> {
        let mut rest = self.attributes;
        loop {
            let equals = memchr::memchr(b'=', rest)?;
            let key = rest[..equals].trim_ascii();
            let value = rest[equals + 1..].trim_ascii_start();
            let (&quote, value) = value.split_first()?;
            if !matches!(quote, b'"' | b'\'') {
                return None;
            }
            let end = memchr::memchr(quote, value)?;
            if key == name.as_bytes() {
                return std::str::from_utf8(&value[..end]).ok();
            }
            rest = &value[end + 1..];
        }
    }
}

/// The next tag from an offset on; comments and declarations are passed over. None at the end and beyond.
pub(super) fn next_tag(file: &[u8], mut offset: usize) -> Result<Option<Tag<'_>>, ReadError> {
    loop {
        let rest = file.get(offset..).unwrap_or_default();
        let Some(start) = memchr::memchr(b'<', rest).map(|found| offset + found) else {
            return Ok(None);
        };
        let rest = &file[start..];
        let passed_over = [(&b"<!--"[..], &b"-->"[..]), (b"<?", b"?>"), (b"<!", b">")];
        let other = passed_over.iter().find(|(begin, _)| rest.starts_with(begin));
        let close = other.map_or(&b">"[..], |(_, end)| end);
        let end = memchr::memmem::find(rest, close);
        let end = end.ok_or_else(|| ReadError::byte(start, "a tag has no end"))?;
        offset = start + end + close.len();
        if other.is_some() {
            continue;
        }
        let inside = &rest[1..end];
        let is_end = inside.starts_with(b"/");
        let inside = inside.strip_prefix(b"/").unwrap_or(inside);
        let is_empty = inside.ends_with(b"/");
        let inside = inside.strip_suffix(b"/").unwrap_or(inside);
        let len = inside.iter().position(u8::is_ascii_whitespace).unwrap_or(inside.len());
        let (name, attributes) = inside.split_at(len);
        return Ok(Some(Tag { name, is_end, is_empty, attributes, start, end: offset }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_have_names_and_attributes() {
        let file =
            b"<?xml?>\n<!-- <a> --><DataArray type=\"Int64\" Name = 'x y' off=\"1\"/> 1 </Cells>";
        let tag = next_tag(file, 0).unwrap().unwrap();
        assert_eq!((tag.name, tag.is_end, tag.is_empty), (&b"DataArray"[..], false, true));
        assert_eq!(tag.attribute("Name"), Some("x y"));
        assert_eq!(tag.attribute("off"), Some("1"));
        assert_eq!(tag.attribute("offset"), None);
        let tag = next_tag(file, tag.end).unwrap().unwrap();
        assert_eq!((tag.name, tag.is_end), (&b"Cells"[..], true));
        assert_eq!(next_tag(file, tag.end).unwrap(), None);
        assert_eq!(next_tag(file, file.len() + 1).unwrap(), None);
        assert_eq!(next_tag(b" <a", 0).unwrap_err().to_string(), "byte 1: a tag has no end");
    }
}
