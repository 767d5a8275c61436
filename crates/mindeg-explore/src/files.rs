//! The page's files, which are part of the program.

/// A file of the page.
pub(crate) struct File {
    pub(crate) kind: &'static str,
    pub(crate) text: &'static str,
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The page itself.
pub(crate) const INDEX: File = File { kind: HTML, text: include_str!("../page/index.html") };

/// A file by its name after `/page/`.
pub(crate) fn named(name: &str) -> Option<File> {
    let file = |kind, text| Some(File { kind, text });
    match name {
        "explore.css" => file(CSS, include_str!("../page/explore.css")),
        "explore.js" => file(SCRIPT, include_str!("../page/explore.js")),
        _ => None,
    }
}
