use std::io::Write;

/// A complete answer, after which the connection is closed. Nothing of it may be kept, framed or guessed at.
pub(crate) fn answer(
    stream: &mut dyn Write,
    status: &str,
    fields: &[(&str, &str)],
    content: &[u8],
    with_content: bool,
) -> std::io::Result<()> {
    let mut text = format!(
        "HTTP/1.1 {status}\r\nContent-Length: {}\r\nConnection: close\r\nCache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\n\
         Cross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Resource-Policy: same-origin\r\n",
        content.len()
    );
    for (name, value) in fields {
        text += &format!("{name}: {value}\r\n");
    }
    text += "\r\n";
    stream.write_all(text.as_bytes())?;
    if with_content {
        stream.write_all(content)?;
    }
    stream.flush()
}

/// An answer in one line of words.
pub(crate) fn words(stream: &mut dyn Write, status: &str, text: &str) -> std::io::Result<()> {
    let content = format!("{text}\n");
    answer(stream, status, &[("Content-Type", "text/plain; charset=utf-8")], content.as_bytes(), true)
}
