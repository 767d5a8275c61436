//! Options that would do nothing are refused, and say what they are for.

use crate::run::mindeg;
use std::fs;

const CUBE: &str = r#"{"corners": [[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[1,0,1],[1,1,1],[0,1,1]],
    "size": 1, "faces": [[0,3,2,1],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}"#;

#[test]
fn options_that_do_nothing_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let cube = folder.path().join("cube.json");
    fs::write(&cube, CUBE).expect("a file");
    let (cube, out) = (cube.to_str().expect("UTF-8"), folder.path().join("q.obj"));
    let out = out.to_str().expect("UTF-8");
    let files = |word: &str| {
        let file = match word {
            "CUBE" => cube,
            "OUT" => out,
            "GUSSET" => "assets/domains/gusset.json",
            "BRACKET" => "assets/models/bracket.obj",
            word => word,
        };
        file.to_owned()
    };
    let refused = |words: &str, says: &str| {
        let run = mindeg(words.split(' ').map(&files));
        assert_eq!(run.code, Some(2), "{words}: {run:?}");
        run.refuses(&[says]);
    };
    for options in [
        "--open box",
        "--least-opening 1",
        "--depth no.asc",
        "--sizes no.asc",
        "--time-step 1",
        "--feature none",
        "--layer none",
        "--name-by none",
        "--corner-angle 5",
        "--repair",
        "--separate",
        "--project auto",
        "--project none",
        "--periodic a=b",
        "--merge-coplanar",
    ] {
        let option = options.split(' ').next().expect("a word");
        refused(&format!("mesh CUBE --interior {options} -o OUT"), &format!("{option} is for "));
    }
    for command in ["degree", "suggest"] {
        for options in ["--feature none", "--corner-angle 5", "--periodic a=b", "--repair"] {
            let option = options.split(' ').next().expect("a word");
            for file in ["CUBE", "BRACKET --size 5"] {
                let words = format!("{command} {file} {options}");
                refused(&words, &format!("{option} is for "));
            }
        }
        refused(&format!("{command} 3,3,3 --feature none"), "these are interval counts alone");
        refused(&format!("{command} GUSSET --merge-coplanar"), "is for models whose faces");
    }
    refused("degree CUBE --boundary-degree 4", "--boundary-degree is for a domain; ");
    refused("degree 3,3,3 --boundary-degree 4", "--boundary-degree is for a domain; ");
    // As of a domain.
    refused("mesh CUBE --growth 0.2 -o OUT", "add --interior");
    for options in ["--merge-coplanar", "--planar-tolerance 1", "--effort 2", "--corner-angle 5"] {
        let option = options.split(' ').next().expect("a word");
        refused(&format!("mesh GUSSET {options} -o OUT"), &format!("{option} is for "));
    }
    refused("mesh --rectangle 4x3 --size 1 --planar-tolerance 1 -o OUT", "a domain");
    // Those that do something are taken.
    for words in [
        "mesh BRACKET --size 5 --merge-coplanar --planar-tolerance 0.01 -o OUT",
        "degree CUBE --effort 0.5",
        "mesh GUSSET --project none -q -o OUT",
    ] {
        let run = mindeg(words.split(' ').map(&files));
        assert_eq!(run.code, Some(0), "{words}: {run:?}");
    }
}
