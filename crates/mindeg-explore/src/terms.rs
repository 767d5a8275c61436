//! Sentences as the page says them: it has no options of the terminal.

/// A text without the clauses that name an option of the terminal, such as `--effort`.
pub(crate) fn without_options(text: &str) -> String {
    let lines = text.split('\n').filter_map(|line| {
        let is_hint = line.starts_with("hint:") && line.contains(OPTION);
        (!is_hint).then(|| line_without_options(line))
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The beginning of an option.
const OPTION: &str = " --";

fn line_without_options(line: &str) -> String {
    // An option that begins the line has a space before it, too.
    let mut left = format!(" {line}");
    while let Some(at) = left.find(OPTION) {
        // The mark before the clause may share its space with the option.
        let marks = [". ", "; ", ": ", ", "].iter();
        let start = marks.filter_map(|mark| left[..=at].rfind(mark)).max().unwrap_or(0);
        let rest = &left[at + OPTION.len()..];
        let after = [". ", "; ", ", "].iter().filter_map(|mark| rest.find(mark)).min();
        let end = after.unwrap_or(rest.strip_suffix('.').unwrap_or(rest).len());
        let end = at + OPTION.len() + end;
        // A whole sentence goes with its own full stop.
        let is_sentence = left[start..].starts_with(". ");
        left.replace_range(start..end, "");
        if is_sentence && !left[start..].starts_with('.') {
            left.insert(start, '.');
        }
    }
    left.trim_start().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clauses_with_options_go_and_the_others_stay() {
        for (text, expected) in [
            ("The gap is 3; --effort 10 looks ten times as long.", "The gap is 3."),
            (
                "Whether less is possible is not known: --effort 10 looks ten times as long.",
                "Whether less is possible is not known.",
            ),
            (
                "No point fits inside: the boundary is never divided. --size S divides its sides into intervals of length S.",
                "No point fits inside: the boundary is never divided.",
            ),
            (
                "Give these sides more intervals, or all of them --size 0.5; or add --condition, which divides edges down to --min-size.",
                "Give these sides more intervals.",
            ),
            (
                "it takes a number of steps, which --effort multiplies, and at most 9 triangles.",
                "it takes a number of steps, and at most 9 triangles.",
            ),
            ("degree 7 on it\nhint: --max-degree 8 gives more", "degree 7 on it"),
            (
                "area 1; --max-degree 7 takes 5% more; no points inside: x",
                "area 1; no points inside: x",
            ),
            ("One. --a does it. Two.", "One. Two."),
            ("--repair cuts them there", ""),
            ("nothing — of it; or -1", "nothing — of it; or -1"),
        ] {
            assert_eq!(without_options(text), expected, "{text}");
        }
    }
}
