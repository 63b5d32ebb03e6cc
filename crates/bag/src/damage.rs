/// Notes a problem once, and not more of them than anybody reads.
pub(crate) fn note(damage: &mut Vec<String>, problem: String) {
    const MOST: usize = 100;
    if damage.len() < MOST && damage.last() != Some(&problem) {
        damage.push(problem);
    }
}
