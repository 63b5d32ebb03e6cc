// Keeps what the page consists of for when there is no network. With one, what the server has goes first.
const KEPT = 'soilctl-workbench';

addEventListener('install', event => event.waitUntil(skipWaiting()));
addEventListener('activate', event => event.waitUntil(keepAll().then(() => clients.claim())));
addEventListener('fetch', event => {
  if (event.request.method === 'GET' && new URL(event.request.url).origin === location.origin) event.respondWith(answer(event.request));
});

// What was loaded before this worker was there.
async function keepAll() {
  const kept = await caches.open(KEPT);
  await kept.addAll(FILES);
}

async function answer(request) {
  const kept = await caches.open(KEPT);
  try {
    const found = await fetch(request);
    if (found.ok) await kept.put(request, found.clone());
    return found;
  } catch (problem) {
    const found = await kept.match(request, {ignoreSearch: true});
    if (found) return found;
    throw problem;
  }
}
