//! t
use mindeg_formats::outlines::*;
fn main() {
    let mut ok = 0;
    let mut bad = std::collections::BTreeMap::<String, usize>::new();
    let mut feats = 0;
    let mut fo = 0;
    let mut vs = 0u64;
    let repair = std::env::var("REPAIR").is_ok();
    let verbose = std::env::var("V").is_ok();
    let size = std::env::var("SIZE").ok().map(|s| s.parse().unwrap());
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).unwrap();
        let f = match format_of(Some(path.as_ref()), &bytes) {
            Ok(f) => f,
            Err(e) => {
                println!("{path}: {e}");
                *bad.entry("format".into()).or_default() += 1;
                continue;
            }
        };
        let t = std::time::Instant::now();
        match read(&bytes, f) {
            Err(e) => {
                println!("{path}: {e}");
                *bad.entry("read".into()).or_default() += 1;
            }
            Ok(mut o) => {
                if verbose {
                    println!(
                        "{path}: {:?} read {:?} notes {:?}",
                        o.features.len(),
                        t.elapsed(),
                        o.notes
                    );
                }
                let t = std::time::Instant::now();
                let n0 = o.notes.len();
                if repair {
                    o = o.repaired().unwrap();
                }
                if verbose {
                    println!("  repaired {:?} {:#?}", t.elapsed(), &o.notes[n0..]);
                }
                let mut all = true;
                for ft in &o.features {
                    feats += 1;
                    match ft.domain(&Division { size, ..Division::default() }) {
                        Ok(d) => {
                            fo += 1;
                            vs += d.placement().vertex_count() as u64;
                        }
                        Err(e) => {
                            all = false;
                            println!("{path}: {:?}: {e}", ft.name)
                        }
                    }
                }
                if all { ok += 1 } else { *bad.entry("domain".into()).or_default() += 1 }
            }
        }
    }
    println!("files ok {ok}, bad {bad:?}; features {feats}, ok {fo}, vertices {vs}");
}
