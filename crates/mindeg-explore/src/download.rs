//! The files of a mesh.

use mindeg_files::{Format, WriteOptions, Writer, in_degrees};
use mindeg_mesh::{Mesh, Progress, Written};
use std::path::PathBuf;

use crate::answer::understood;
use crate::api::{FormatFact, View};
use crate::command::file_stem;
use crate::format::{format_named, formats};
use crate::mesh::Made;

/// A file to save.
pub(crate) struct Download {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
}

/// A file of the mesh that a body asks for: the mesh of a view, or of
/// the view it names, in a format by its name.
///
/// # Errors
///
/// The error, in a sentence.
pub(crate) fn download(
    body: &[u8],
    view: Option<View>,
    format: &str,
    file: usize,
    progress: Progress<'_>,
) -> Result<Download, String> {
    let format = format_named(format)?;
    let (request, domain) = understood(body).map_err(|(message, _)| message)?;
    let view = view.unwrap_or(request.view);
    let stem = file_stem(&domain, view, request.goal);
    let made = Made::new(&domain, &request, view, progress)?;
    let projection = domain.projection().copied().filter(|_| format.in_degrees());
    let degrees = projection.map(|projection| move |point| in_degrees(&projection, point));
    let place = degrees.as_ref().map(|place| place as _);
    written(&Written { mesh: made.mesh(), made_by: None, place }, format, &stem, file)
}

/// A mesh as a file of a format, by the place of the file among those of the format.
///
/// # Errors
///
/// The error, in a sentence.
pub(crate) fn written(
    mesh: &dyn Mesh,
    format: Format,
    stem: &str,
    file: usize,
) -> Result<Download, String> {
    let path = PathBuf::from(format!("{stem}.{}", format.extension()));
    let names: Vec<String> =
        format.files(&path).iter().map(|path| path.display().to_string()).collect();
    let name = names.get(file).cloned();
    let name = name.ok_or_else(|| format!("this format has {} files", names.len()))?;
    let contents = || {
        let writer = Writer::new(format, WriteOptions::default(), mesh, mesh.triangle_count())?;
        let mut contents = vec![Vec::new(); names.len()];
        let mut files: Vec<(&str, &mut Vec<u8>)> =
            names.iter().map(String::as_str).zip(&mut contents).collect();
        writer.write(mesh, &mut files, Progress::NONE)?;
        Ok(contents)
    };
    let mut contents = contents().map_err(|error: mindeg_files::WriteError| error.to_string())?;
    Ok(Download { name, bytes: contents.swap_remove(file) })
}

/// The formats that are written here, for the page.
pub(crate) fn format_facts() -> Vec<FormatFact> {
    let facts = formats().map(|format| {
        let path = PathBuf::from("mesh").with_extension(format.extension());
        let extension = |path: &PathBuf| path.extension().map(|e| e.to_string_lossy().into_owned());
        FormatFact {
            name: format.name(),
            description: format.description(),
            files: format.files(&path).iter().filter_map(extension).collect(),
            is_planar: format.is_planar(),
        }
    });
    facts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refused_download_says_what_is_wrong() {
        for (body, words) in [
            ("[]", "the request is not what the page sends"),
            (r#"{"domain": {"rectangle": {"width": 4, "height": 3}}}"#, "intervals"),
            (r#"{"domain": {"ring": [[0, 0], [1, 0], [0]]}}"#, "ring[2]"),
        ] {
            let refusal = download(body.as_bytes(), None, "obj", 0, Progress::NONE).err().unwrap();
            assert!(refusal.contains(words), "{refusal}");
            // Nobody has seen the text of the page's domain.
            assert!(!refusal.contains("line 1, column"), "{refusal}");
        }
    }
}
