// Encodes and decodes the Foxglove WebSocket protocol. Integers are little-endian. Server input is
// validated here: anything malformed becomes undefined.

export const kSubprotocols = ['foxglove.sdk.v1', 'foxglove.websocket.v1'];

export interface Channel {
  id: number;
  topic: string;
}

export interface Service {
  id: number;
  name: string;
}

export type ServerText =
  | { op: 'serverInfo'; sessionId: string; metadata: Record<string, string> }
  | { op: 'advertise'; channels: Channel[] }
  | { op: 'advertiseServices'; services: Service[] }
  | { op: 'serviceCallFailure'; callId: number; message: string }
  | { op: 'status'; level: number; message: string };

export type ServerBinary =
  | { op: 'message'; subscriptionId: number; payload: Uint8Array }
  | { op: 'serviceResponse'; callId: number; payload: Uint8Array };

type Dictionary = Record<string, unknown>;

const isObject = (value: unknown): value is Dictionary =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isId = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;
const text = (value: unknown): string => (typeof value === 'string' ? value : '');
const list = (value: unknown): Dictionary[] => (Array.isArray(value) ? value.filter(isObject) : []);

/** A text frame of the server; undefined if it is malformed or irrelevant to a viewer. */
export function parseText(frame: string): ServerText | undefined {
  let message: unknown;
  try {
    message = JSON.parse(frame);
  } catch {
    return undefined;
  }
  if (!isObject(message)) return undefined;
  switch (message.op) {
    case 'serverInfo':
      return {
        op: 'serverInfo',
        sessionId: text(message.sessionId),
        metadata: isObject(message.metadata)
          ? Object.fromEntries(Object.entries(message.metadata).map(([key, value]) => [key, text(value)]))
          : {},
      };
    case 'advertise':
      return {
        op: 'advertise',
        channels: list(message.channels)
          .filter((channel) => isId(channel.id))
          .map((channel) => ({ id: channel.id as number, topic: text(channel.topic) })),
      };
    case 'advertiseServices':
      return {
        op: 'advertiseServices',
        services: list(message.services)
          .filter((service) => isId(service.id))
          .map((service) => ({ id: service.id as number, name: text(service.name) })),
      };
    case 'serviceCallFailure':
      if (!isId(message.callId)) return undefined;
      return { op: 'serviceCallFailure', callId: message.callId, message: text(message.message) };
    case 'status':
      return { op: 'status', level: Number(message.level) || 0, message: text(message.message) };
    default:
      return undefined;
  }
}

/** A binary frame of the server; the payload is a view into `frame`. */
export function parseBinary(frame: ArrayBuffer): ServerBinary | undefined {
  const view = new DataView(frame);
  if (view.byteLength < 1) return undefined;
  switch (view.getUint8(0)) {
    case 1:
      if (view.byteLength < 13) return undefined;
      return {
        op: 'message',
        subscriptionId: view.getUint32(1, true),
        payload: new Uint8Array(frame, 13),
      };
    case 3: {
      if (view.byteLength < 13) return undefined;
      const length = view.getUint32(9, true);
      if (length > view.byteLength - 13) return undefined;
      return {
        op: 'serviceResponse',
        callId: view.getUint32(5, true),
        payload: new Uint8Array(frame, 13 + length),
      };
    }
    default:
      return undefined;
  }
}

export function subscribe(subscriptions: { id: number; channelId: number }[]): string {
  return JSON.stringify({ op: 'subscribe', subscriptions });
}

export function unsubscribe(subscriptionIds: number[]): string {
  return JSON.stringify({ op: 'unsubscribe', subscriptionIds });
}

export function setParameter(name: string, value: number | boolean | string): string {
  return JSON.stringify({ op: 'setParameters', parameters: [{ name, value }] });
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
