//! Reads files and counts which of their polygons are domains:
//! `cargo run --release --example count_domains -- [--repair] icons/*.svg`

use std::path::Path;

use mindeg_outlines::{Division, OutlineError, OutlineFormat, Outlines, read};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut paths: Vec<String> = std::env::args().skip(1).collect();
    let repair = paths.first().is_some_and(|option| option == "--repair");
    paths.drain(..usize::from(repair));
    let (mut files, mut polygons, mut domains, mut vertices) = (0, 0, 0, 0);
    for path in &paths {
        let outlines = match outlines(&std::fs::read(path)?, path, repair) {
            Ok(outlines) => outlines,
            Err(error) => {
                println!("{path}: {error}");
                continue;
            }
        };
        let before = polygons - domains;
        for feature in &outlines.features {
            polygons += 1;
            match feature.domain(&Division::default()) {
                Ok(domain) => {
                    domains += 1;
                    vertices += u64::from(domain.rings().vertex_count());
                }
                Err(error) => {
                    println!("{path}: {}: {error}", feature.name.as_deref().unwrap_or(""))
                }
            }
        }
        files += usize::from(polygons - domains == before);
    }
    println!(
        "{files} of {} files, {domains} of {polygons} polygons, {vertices} vertices",
        paths.len()
    );
    Ok(())
}

fn outlines(bytes: &[u8], path: &str, repair: bool) -> Result<Outlines, OutlineError> {
    let path = Path::new(path);
    let format = OutlineFormat::of_path(path).or_else(|| OutlineFormat::of_content(bytes));
    // Domains in JSON are not outlines, and do not count.
    let Some(format) = format else { return Ok(Outlines::default()) };
    let beside = |extension: &str| std::fs::read(path.with_extension(extension));
    let outlines = read(bytes, format, beside)?;
    if repair { outlines.repaired(None) } else { Ok(outlines) }
}
