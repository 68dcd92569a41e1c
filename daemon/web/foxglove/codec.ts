// Encodes and decodes the Foxglove WebSocket protocol. Integers are little-endian. Server input is
// validated here: anything malformed becomes undefined.

export const kSubprotocols = ['foxglove.sdk.v1', 'foxglove.websocket.v1'];

export interface Channel {
  id: number;
  topic: string;
  encoding: string;
  schemaName: string;
}

export interface Service {
  id: number;
  name: string;
}

export type ParameterValue = number | boolean | string | ParameterValue[] | { [key: string]: ParameterValue };

export interface Parameter {
  name: string;
  value: ParameterValue | undefined;
}

export type ServerText =
  | { op: 'serverInfo'; name: string; sessionId: string; capabilities: string[]; metadata: Record<string, string> }
  | { op: 'advertise'; channels: Channel[] }
  | { op: 'unadvertise'; channelIds: number[] }
  | { op: 'advertiseServices'; services: Service[] }
  | { op: 'unadvertiseServices'; serviceIds: number[] }
  | { op: 'parameterValues'; parameters: Parameter[]; id: string | undefined }
  | { op: 'serviceCallFailure'; callId: number; message: string }
  | { op: 'status'; level: number; message: string };

export type ServerBinary =
  | { op: 'message'; subscriptionId: number; time_s: number; payload: Uint8Array }
  | { op: 'time'; time_s: number }
  | { op: 'serviceResponse'; serviceId: number; callId: number; encoding: string; payload: Uint8Array };

type Dictionary = Record<string, unknown>;

const isObject = (value: unknown): value is Dictionary =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isId = (value: unknown): value is number => Number.isSafeInteger(value) && (value as number) >= 0;
const text = (value: unknown): string => (typeof value === 'string' ? value : '');
const list = (value: unknown): Dictionary[] => (Array.isArray(value) ? value.filter(isObject) : []);
const ids = (value: unknown): number[] => (Array.isArray(value) ? value.filter(isId) : []);

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
        name: text(message.name),
        sessionId: text(message.sessionId),
        capabilities: Array.isArray(message.capabilities) ? message.capabilities.map(text) : [],
        metadata: isObject(message.metadata)
          ? Object.fromEntries(Object.entries(message.metadata).map(([key, value]) => [key, text(value)]))
          : {},
      };
    case 'advertise':
      return {
        op: 'advertise',
        channels: list(message.channels)
          .filter((channel) => isId(channel.id))
          .map((channel) => ({
            id: channel.id as number,
            topic: text(channel.topic),
            encoding: text(channel.encoding),
            schemaName: text(channel.schemaName),
          })),
      };
    case 'unadvertise':
      return { op: 'unadvertise', channelIds: ids(message.channelIds) };
    case 'advertiseServices':
      return {
        op: 'advertiseServices',
        services: list(message.services)
          .filter((service) => isId(service.id))
          .map((service) => ({ id: service.id as number, name: text(service.name) })),
      };
    case 'unadvertiseServices':
      return { op: 'unadvertiseServices', serviceIds: ids(message.serviceIds) };
    case 'parameterValues':
      return {
        op: 'parameterValues',
        parameters: list(message.parameters)
          .filter((parameter) => typeof parameter.name === 'string')
          .map((parameter) => ({
            name: text(parameter.name),
            value: parameter.value as ParameterValue | undefined,
          })),
        id: typeof message.id === 'string' ? message.id : undefined,
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
        time_s: Number(view.getBigUint64(5, true)) * 1e-9,
        payload: new Uint8Array(frame, 13),
      };
    case 2:
      if (view.byteLength < 9) return undefined;
      return { op: 'time', time_s: Number(view.getBigUint64(1, true)) * 1e-9 };
    case 3: {
      if (view.byteLength < 13) return undefined;
      const length = view.getUint32(9, true);
      if (length > view.byteLength - 13) return undefined;
      return {
        op: 'serviceResponse',
        serviceId: view.getUint32(1, true),
        callId: view.getUint32(5, true),
        encoding: new TextDecoder().decode(new Uint8Array(frame, 13, length)),
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

/** Requests parameters, all if `names` is empty. The answer has the same `id`. */
export function getParameters(names: string[], id: string): string {
  return JSON.stringify({ op: 'getParameters', parameterNames: names, id });
}

export function setParameter(name: string, value: ParameterValue, id: string): string {
  return JSON.stringify({ op: 'setParameters', parameters: [{ name, value }], id });
}

export function subscribeParameters(names: string[]): string {
  return JSON.stringify({ op: 'subscribeParameterUpdates', parameterNames: names });
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
