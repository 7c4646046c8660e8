// Something long that the service does on demand: its button, its cancelling, and how long it has been going on.

const byId = (id) => document.getElementById(id);

/**
 * `ids`: { start, cancel, progress, elapsed } of the elements. `run(ask, { onAnswer, onError })` does `ask(signal)` and passes on what comes
 * of it, unless it was cancelled or another has begun.
 */
export function createSearch(ids) {
  let current = null;

  function show(isRunning) {
    for (const id of [ids.cancel, ids.progress, ids.elapsed]) byId(id).hidden = !isRunning;
    byId(ids.start).disabled = isRunning;
  }

  function cancel() {
    current?.abort();
    current = null;
    show(false);
  }

  async function run(ask, { onAnswer, onError }) {
    cancel();
    const mine = new AbortController();
    current = mine;
    const started = performance.now();
    const tell = () => { byId(ids.elapsed).textContent = `${Math.round((performance.now() - started) / 1000)} s`; };
    const clock = setInterval(tell, 1000);
    tell();
    show(true);
    try {
      const reply = await ask(mine.signal);
      if (!mine.signal.aborted) onAnswer(reply);
    } catch (error) {
      if (!mine.signal.aborted) onError(error);
    } finally {
      clearInterval(clock);
      if (current === mine) cancel();
    }
  }

  return { run, cancel };
}
