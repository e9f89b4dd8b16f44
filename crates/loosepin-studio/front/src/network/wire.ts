// Speaks with the server: HTTP for files, a WebSocket for all that is live.
import type { FromPage, ToPage } from '../messages.ts';
import { tab } from './tab.ts';

const tokenKey = 'loosepin-token';

/** The server's no: its words can be shown as they are. */
export class Refusal extends Error {
  constructor(readonly status: number, message: string, readonly hint: string | null) {
    super(message);
  }
}

/** Takes the token out of the address, so that it is in no bookmark and no screenshot. */
export function takeToken(address: string): void {
  const given = /^#token=([0-9A-Fa-f]+)/.exec(location.hash)?.[1];
  if (given === undefined) return;
  sessionStorage.setItem(tokenKey, given);
  history.replaceState(null, '', location.pathname + address);
}

function token(): string {
  return sessionStorage.getItem(tokenKey) ?? '';
}

/** What a browser sends of a page that is gone. */
const mostOfLeaving = 60_000;

/** `isLeaving` sends it even where the page is gone by then, as far as the browser does that. */
export async function ask<T>(method: 'GET' | 'PUT' | 'POST', path: string, body?: unknown, isLeaving = false): Promise<T> {
  const headers: Record<string, string> = { Authorization: 'Bearer ' + token() };
  const isRaw = body instanceof ArrayBuffer;
  if (body !== undefined) headers['Content-Type'] = isRaw ? 'application/octet-stream' : 'application/json';
  let answer: Response;
  try {
    const sent = body === undefined ? null : isRaw ? body : JSON.stringify(body);
    const keepalive = isLeaving && typeof sent === 'string' && sent.length < mostOfLeaving;
    answer = await fetch('.' + path, { method, headers, body: sent, keepalive });
  } catch {
    throw new Refusal(0, '', null);
  }
  const content: unknown = await answer.json().catch(() => null);
  if (answer.ok) return content as T;
  const said = content as { message?: unknown; hint?: unknown } | null;
  throw new Refusal(
    answer.status,
    typeof said?.message === 'string' ? said.message : '',
    typeof said?.hint === 'string' ? said.hint : null,
  );
}

export type Connection = { state: 'connecting' | 'open' } | { state: 'lost'; seconds: number };

const longestWait = 10;

/** A WebSocket that comes back: after 1, 2, 4 … 10 s. */
export class Live {
  private socket: WebSocket | null = null;
  private wait = 1;
  private timer = 0;
  private isGreeted = false;

  constructor(private readonly hear: (message: ToPage) => void, private readonly tell: (connection: Connection) => void) {}

  open(): void {
    this.tell({ state: 'connecting' });
    const socket = new WebSocket(new URL('./live', location.href).href.replace(/^http/, 'ws').replace(/#.*$/, ''));
    this.socket = socket;
    socket.onopen = () => socket.send(JSON.stringify({ kind: 'hello', token: token(), tab } satisfies FromPage));
    socket.onmessage = (event: MessageEvent<string>) => {
      const message = JSON.parse(event.data) as ToPage;
      if (message.kind === 'hello') {
        this.isGreeted = true;
        this.wait = 1;
        this.tell({ state: 'open' });
      }
      this.hear(message);
    };
    socket.onclose = () => {
      this.isGreeted = false;
      this.tell({ state: 'lost', seconds: this.wait });
      this.timer = window.setTimeout(() => this.open(), this.wait * 1000);
      this.wait = Math.min(this.wait * 2, longestWait);
    };
  }

  /** At once, with another token. */
  again(): void {
    clearTimeout(this.timer);
    if (this.socket) this.socket.onclose = null;
    this.socket?.close();
    this.isGreeted = false;
    this.wait = 1;
    this.open();
  }

  send(message: FromPage): boolean {
    if (!this.isGreeted || this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }
}
