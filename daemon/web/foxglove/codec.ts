// Encodes and decodes the Foxglove WebSocket protocol. Integers are little-endian. Server input is
// validated here: what is malformed is left out.

export const kSubprotocols = ['foxglove.sdk.v1', 'foxglove.websocket.v1'];

/** A binary frame of the server: a message of a subscription, or the response to a call. */
export interface ServerBinary {
  op: 'message' | 'response';
  /** Of the subscription, or of the call. */
  id: number;
  /** A view into the frame. */
  payload: Uint8Array;
}

type Dictionary = Record<string, unknown>;

const isObject = (value: unknown): value is Dictionary =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isId = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;

/** A text; empty for anything else. */
export const text = (value: unknown): string => (typeof value === 'string' ? value : '');

/** The texts of an object by their keys. */
export const texts = (value: unknown): Record<string, string> =>
  isObject(value) ? Object.fromEntries(Object.entries(value).map(([key, each]) => [key, text(each)])) : {};

/** The ids of a list's entries by the text in their field `key`; entries without a usable id are left out. */
export function ids(list: unknown, key: string): [name: string, id: number][] {
  const entries: unknown[] = Array.isArray(list) ? list : [];
  return entries.flatMap((each): [string, number][] => (isObject(each) && isId(each.id) ? [[text(each[key]), each.id]] : []));
}

/** The object that a text frame holds; empty if it holds none. */
export function parseText(frame: string): Dictionary {
  try {
    const message: unknown = JSON.parse(frame);
    return isObject(message) ? message : {};
  } catch {
    return {};
  }
}

/** Undefined if the frame is malformed or irrelevant to a viewer. */
export function parseBinary(frame: ArrayBuffer): ServerBinary | undefined {
  const view = new DataView(frame);
  if (view.byteLength < 13) return undefined;
  const op = view.getUint8(0);
  if (op === 1) return { op: 'message', id: view.getUint32(1, true), payload: new Uint8Array(frame, 13) };
  const encoding_bytes = view.getUint32(9, true);
  if (op !== 3 || encoding_bytes > view.byteLength - 13) return undefined;
  return { op: 'response', id: view.getUint32(5, true), payload: new Uint8Array(frame, 13 + encoding_bytes) };
}

/** A service call with a JSON request. */
export function callService(serviceId: number, callId: number, request: unknown): ArrayBuffer {
  const encoding = new TextEncoder().encode('json');
  const payload = new TextEncoder().encode(JSON.stringify(request));
  const frame = new ArrayBuffer(13 + encoding.length + payload.length);
  const view = new DataView(frame);
  view.setUint8(0, 2);
  view.setUint32(1, serviceId, true);
  view.setUint32(5, callId, true);
  view.setUint32(9, encoding.length, true);
  new Uint8Array(frame, 13).set(encoding);
  new Uint8Array(frame, 13 + encoding.length).set(payload);
  return frame;
}
