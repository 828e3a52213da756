import { address_of, start_state, state_of } from "./address.js";
import { later } from "./dom.js";

// What the reader has chosen. A change is told to all who asked, and goes into the address.
export const state = start_state();
const listeners = [];

export const on_change = listener => listeners.push(listener);

// change takes new values; listeners are told which keys differ. A drag that is not done yet leaves the address alone.
export function change(patch, done = true) {
  const keys = new Set(Object.keys(patch).filter(key => JSON.stringify(state[key]) !== JSON.stringify(patch[key])));
  if (!keys.size && !done) return;
  Object.assign(state, patch);
  if (keys.size) listeners.forEach(listener => listener(keys, done));
  if (done) write_address();
}

const write_address = later(() => {
  const address = address_of(state);
  if (address !== location.hash) history.replaceState(null, "", address || location.pathname + location.search);
}, 150);

// read_address takes the state from the address, and says which of its keys it does not know.
export function read_address() {
  const { state: next, trouble } = state_of(location.hash);
  const keys = new Set(Object.keys(next).filter(key => JSON.stringify(state[key]) !== JSON.stringify(next[key])));
  Object.assign(state, next);
  if (keys.size) listeners.forEach(listener => listener(keys, true));
  return trouble;
}
