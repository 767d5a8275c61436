//! The page's files, embedded in the program.

use std::borrow::Cow;

/// A file of the page.
pub(crate) struct File {
    pub(crate) kind: &'static str,
    pub(crate) text: Cow<'static, str>,
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The page itself.
pub(crate) const INDEX: File =
    File { kind: HTML, text: Cow::Borrowed(include_str!("../page/index.html")) };

/// A file by its name after `/page/`. The style and the viewer are those of the reports.
pub(crate) fn named(name: &str) -> Option<File> {
    let script = |text| Some(File { kind: SCRIPT, text: Cow::Borrowed(text) });
    match name {
        "style.css" => Some(File { kind: CSS, text: mindeg_compare::viewer_style().into() }),
        "explore.css" => {
            Some(File { kind: CSS, text: Cow::Borrowed(include_str!("../page/explore.css")) })
        }
        "space.js" => script(mindeg_compare::space_script()),
        "viewer.js" => Some(File { kind: SCRIPT, text: mindeg_compare::viewer_script().into() }),
        "asking.js" => script(include_str!("../page/asking.js")),
        "choices.js" => script(include_str!("../page/choices.js")),
        "curve.js" => script(include_str!("../page/curve.js")),
        "domain.js" => script(include_str!("../page/domain.js")),
        "editing.js" => script(include_str!("../page/editing.js")),
        "editor.js" => script(include_str!("../page/editor.js")),
        "explore.js" => script(include_str!("../page/explore.js")),
        "fields.js" => script(include_str!("../page/fields.js")),
        "inside.js" => script(include_str!("../page/inside.js")),
        "names.js" => script(include_str!("../page/names.js")),
        "painter.js" => script(include_str!("../page/painter.js")),
        "pictures.js" => script(include_str!("../page/pictures.js")),
        "server.js" => script(include_str!("../page/server.js")),
        "show.js" => script(include_str!("../page/show.js")),
        "sides.js" => script(include_str!("../page/sides.js")),
        "solid.js" => script(include_str!("../page/solid.js")),
        "stage.js" => script(include_str!("../page/stage.js")),
        "state.js" => script(include_str!("../page/state.js")),
        "take.js" => script(include_str!("../page/take.js")),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_that_the_page_asks_for_is_there() {
        let texts =
            ["explore.js", "asking.js", "pictures.js", "editing.js", "painter.js", "show.js"]
                .iter()
                .filter_map(|name| named(name))
                .map(|file| file.text)
                .chain([INDEX.text]);
        let mut asked = 0;
        for text in texts {
            for start in ["\"/page/", " from \"./"] {
                for after in text.split(start).skip(1) {
                    let name = after.split('"').next().unwrap_or_default();
                    assert!(named(name).is_some(), "{name}");
                    asked += 1;
                }
            }
        }
        assert!(asked > 20, "{asked} names");
    }
}
