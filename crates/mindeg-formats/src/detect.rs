//! Which format a file is in, by its first bytes.

use std::path::Path;

use crate::format::{Format, extensions};

impl Format {
    /// The format that the first bytes of a file tell; some thousand of them are enough. Formats
    /// that are nothing but numbers tell none.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// assert_eq!(Format::of_content(b"$MeshFormat\n4.1 0 8\n"), Some(Format::Msh));
    /// assert_eq!(Format::of_content(b"3 2 0 1\n1 0 0 1\n"), None);
    /// ```
    #[must_use]
    pub fn of_content(head: &[u8]) -> Option<Self> {
        let text = head.strip_prefix("\u{feff}".as_bytes()).unwrap_or(head).trim_ascii_start();
        let begins = |format: &Self| (format.facts().begins)(text);
        Self::WRITTEN.into_iter().find(begins).or_else(|| Self::of_first_word(text))
    }

    /// The format that all bytes of a file tell, for a file without a name: also one of numbers, by
    /// its length or its first lines.
    ///
    /// # Example
    ///
    /// ```
    /// use mindeg_formats::Format;
    ///
    /// assert_eq!(Format::of_all(b"3 2 0 1\n1 0 0 1\n"), Some(Format::Node));
    /// assert_eq!(Format::of_all(&[&[0; 80][..], &[1, 0, 0, 0], &[0; 50]].concat()), Some(Format::Stl));
    /// assert_eq!(Format::of_all(b"a letter\n"), None);
    /// ```
    #[must_use]
    pub fn of_all(bytes: &[u8]) -> Option<Self> {
        let fits = |format: &Self| (format.facts().fits)(bytes);
        Self::of_content(bytes).or_else(|| Self::READ.into_iter().find(fits))
    }

    /// The format of the first word in the first line that is not a comment.
    fn of_first_word(text: &[u8]) -> Option<Self> {
        let is_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let mut lines = text.split(is_end).map(<[u8]>::trim_ascii);
        let line = lines.find(|line| !matches!(line, [] | [b'#' | b'%', ..]))?;
        let first = line.split(|byte| byte.is_ascii_whitespace() || *byte == b'=').next()?;
        let is_first = |word: &&str| word.as_bytes() == first;
        Self::WRITTEN.into_iter().find(|format| format.facts().first_words.iter().any(is_first))
    }
}

/// The format of a file with a name and some first bytes: what the extension says, unless the
/// content is of another format for sure; else what the content says. An error is a sentence.
pub(crate) fn format_of(path: &Path, head: &[u8]) -> Result<Format, String> {
    let named = Format::of_path(path);
    let found = Format::of_content(head);
    let format = match (named, found) {
        (Some(named), Some(_)) if (named.facts().fits)(head) => named,
        // The first word of an OBJ is too short to be sure of anything else.
        (Some(named), Some(found)) if found != named && found != Format::Obj => {
            let [name, right] = [named, found].map(Format::extension);
            let [named, found] = [named, found].map(Format::description);
            return Err(format!(
                "the name ends in .{name}, which is {named}, but the content is {found}; rename the \
                 file to end in .{right}"
            ));
        }
        (Some(format), _) | (None, Some(format)) => format,
        (None, None) => {
            return Err(format!(
                "neither the name nor the content tells a mesh format that can be read; the name \
                 must end in {}",
                extensions(&Format::READ)
            ));
        }
    };
    if format.facts().read.is_some() {
        return Ok(format);
    }
    Err(format!(
        "mindeg writes .{} files and does not read them as meshes; a mesh ends in {}",
        format.extension(),
        extensions(&Format::READ)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_tells_the_format() {
        for (content, format) in [
            (&b"glTF\x02"[..], Some(Format::Glb)),
            (b" \n{\"asset\": {}}", Some(Format::Gltf)),
            (b"{\"rectangle\": {}}", None),
            ("\u{feff}{ \"meshes\": []}".as_bytes(), Some(Format::Gltf)),
            (b"# a comment\nv 0 0 0\n", Some(Format::Obj)),
            (b"ply\r\nformat ascii 1.0\r\n", Some(Format::Ply)),
            (b"PK\x03\x04", Some(Format::Npz)),
            (b"$Comments\nby hand\n$EndComments\n$MeshFormat\n", Some(Format::Msh)),
            (b"# vtk DataFile Version 4.2\n", Some(Format::Vtk)),
            (b"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">", Some(Format::Vtu)),
            (b"<svg xmlns=\"\">", Some(Format::Svg)),
            (b"# numbers\nOFF\n", Some(Format::Off)),
            (b"solid part\n", Some(Format::Stl)),
            (b"MESH2D\n", Some(Format::Sms2dm)),
            (b"% by hand\nNDIME= 2\n", Some(Format::Su2)),
            (b"*HEADING\n", Some(Format::Inp)),
            (b"3 2 0 0\n", None),
            (b"", None),
        ] {
            assert_eq!(Format::of_content(content), format, "{:?}", content.escape_ascii());
        }
    }

    #[test]
    fn a_name_that_lies_is_told() {
        let of = |path: &str, head: &[u8]| format_of(path.as_ref(), head);
        assert_eq!(of("a.vtk", b"# vtk DataFile Version 3.0\n"), Ok(Format::Vtk));
        assert_eq!(of("a.gltf", b"glTF\x02\0\0\0"), Ok(Format::Gltf));
        assert_eq!(of("a.node", b"v 1 2 3"), Ok(Format::Node));
        assert_eq!(of("a.mesh", b"OFF\n"), Ok(Format::Off));
        let starts = |path: &str, head: &[u8], start: &str| {
            let error = of(path, head).unwrap_err();
            assert!(error.starts_with(start), "{error}");
        };
        starts("a.svg", b"<svg>", "mindeg writes .svg files and does not read them");
        starts("a.txt", b"hello", "neither the name nor the content tells");
        assert_eq!(of("a.14", b"solid rock\r\n 8 9 = sizes\r\n"), Ok(Format::Fort14));
        assert_eq!(of("a.14", b"OFF\n8 9 0\n"), Ok(Format::Fort14));
        starts("a.14", b"ply\nformat ascii 1.0\n", "the name ends in .14, which is ADCIRC");
        let lie = of("a.vtk", b"<VTKFile type=\"UnstructuredGrid\">").unwrap_err();
        assert_eq!(
            lie,
            "the name ends in .vtk, which is legacy VTK, but the content is VTK's XML \
             unstructured grid; rename the file to end in .vtu"
        );
    }
}
