// In a worker: the first message is the module, whose greeting goes to the page; all others are the page's. This follows wasm-bindgen's
// script in one file.
onmessage = ({data}) => {
  if (data instanceof WebAssembly.Module) { wasm_bindgen.initSync({module: data}); wasm_bindgen.open(); } else wasm_bindgen.obey(data);
};
