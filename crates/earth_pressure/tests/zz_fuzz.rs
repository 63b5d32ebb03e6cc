//! temp
use soilctl_earth_pressure::table::*;
use soilctl_earth_pressure::*;
use std::collections::HashMap;
use std::sync::{Arc,Mutex};
#[test]
fn fuzz() {
    let axes = [vec![70.0, 85.0,90.0], vec![30.0, 37.5,40.0], vec![0.0, 15.0,20.0]];
    let t = PredictionTable::fill(&ChenLiu, axes).unwrap();
    let dir = tempfile::tempdir_in("/dev/shm").unwrap();
    let path = dir.path().join("t.parquet");
    write_parquet(&t, "x", &path).unwrap();
    let mut goods = vec![std::fs::read(&path).unwrap()];
    for opt in [false,true] { for v2 in [false,true] { for dict in [false,true] { for snap in [false,true] {
        use parquet::basic::*; use parquet::file::properties::*; use parquet::data_type::*;
        let w = if opt {"optional"} else {"required"};
        let schema = Arc::new(parquet::schema::parser::parse_message_type(&format!("message m {{ {w} binary status (UTF8); {w} double alpha_deg; {w} double phi_deg; {w} double delta_deg; {w} double k_net; }}")).unwrap());
        let props = Arc::new(WriterProperties::builder().set_compression(if snap {Compression::SNAPPY} else {Compression::UNCOMPRESSED}).set_dictionary_enabled(dict).set_writer_version(if v2 {WriterVersion::PARQUET_2_0} else {WriterVersion::PARQUET_1_0}).set_encoding(Encoding::PLAIN).set_data_page_row_count_limit(10).set_write_batch_size(5).build());
        let mut buf = Vec::new();
        let mut f = parquet::file::writer::SerializedFileWriter::new(&mut buf, schema, props).unwrap();
        let mut g = f.next_row_group().unwrap();
        let rows: Vec<_> = t.filled().collect();
        let lv = vec![1i16; rows.len()]; let l = opt.then_some(&lv[..]);
        let mut c = g.next_column().unwrap().unwrap();
        let words: Vec<ByteArray> = rows.iter().map(|_| ByteArray::from("solved")).collect();
        c.typed::<ByteArrayType>().write_batch(&words, l, None).unwrap(); c.close().unwrap();
        for i in 0..4 { let x: Vec<f64> = rows.iter().map(|(n,c)| if i<3 {n[i]} else {c.k_net}).collect();
            let mut c = g.next_column().unwrap().unwrap(); c.typed::<DoubleType>().write_batch(&x, l, None).unwrap(); c.close().unwrap(); }
        g.close().unwrap(); f.close().unwrap();
        std::fs::write(&path,&buf).unwrap();
        assert_eq!(read_parquet(&path).map(|x|x.0).unwrap().filled().collect::<Vec<_>>(), rows, "{opt} {v2} {dict} {snap}");
        goods.push(buf);
    }}}}
    let panics: Arc<Mutex<HashMap<String,usize>>> = Arc::default();
    let p2 = panics.clone();
    std::panic::set_hook(Box::new(move |i| { let l=i.location().unwrap(); *p2.lock().unwrap().entry(format!("{}:{} {}",l.file(),l.line(),i)).or_default()+=1; }));
    let n: usize = std::env::var("N").ok().and_then(|x|x.parse().ok()).unwrap_or(1000);
    let mut s = std::env::var("SEED").ok().and_then(|x|x.parse().ok()).unwrap_or(12345u64);
    let mut r = move |m: usize| { s ^= s<<13; s ^= s>>7; s ^= s<<17; (s>>11) as usize % m };
    let mut errs: HashMap<String,usize> = HashMap::new(); let mut ok=0; let mut slow=0.0f64;
    for i in 0..n {
        let g=&goods[i%goods.len()];
        let mut b = g.clone();
        for _ in 0..1+r(3) { let p=r(b.len()); b[p]= match r(4){0=>r(256) as u8,1=>b[p]^(1<<r(8)),2=>0xff,_=>b[p].wrapping_add(1)}; }
        std::fs::write(&path,&b).unwrap();
        let t0=std::time::Instant::now();
        match std::panic::catch_unwind(||read_parquet(&path).map(|_|())) { Ok(Ok(()))=>ok+=1, Ok(Err(e))=>{*errs.entry(e.to_string().replace(|c:char|c.is_ascii_digit(),"#")).or_default()+=1;}, Err(_)=>{} }
        let dt=t0.elapsed().as_secs_f64(); if dt>slow {slow=dt; }
    }
    let _ = std::panic::take_hook();
    println!("ok {ok} of {n}, slowest {slow}");
    for (k,v) in panics.lock().unwrap().iter(){ println!("PANIC {v} {k}"); }
    let mut e:Vec<_>=errs.into_iter().collect(); e.sort_by_key(|x|std::cmp::Reverse(x.1)); for (k,v) in e.iter().take(60){println!("{v} {k}");}
}
