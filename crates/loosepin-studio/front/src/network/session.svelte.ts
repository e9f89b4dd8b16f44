// The one connection of the page, and what it says to all screens.
import type { CheckAnswer, FromPage, HelloAnswer, Job, LookAnswer, ToPage } from '../messages.ts';
import { ask, Live, Refusal, type Connection } from './wire.ts';

class Session {
  connection = $state.raw<Connection>({ state: 'connecting' });
  hello = $state.raw<HelloAnswer | null>(null);
  isRefused = $state(false);
  jobs = $state.raw<Job[]>([]);
  /** What is to be known on the next screen too. */
  notice = $state<string | null>(null);
  /** A message that the server did not take, in its words. */
  refusal = $state<string | null>(null);
  private readonly live = new Live((message) => this.hear(message), (connection) => this.connected(connection));
  private readonly seenBy = new Set<(seen: LookAnswer) => void>();
  private readonly triedBy = new Set<(found: CheckAnswer) => void>();
  private readonly changedBy = new Set<(path: string) => void>();
  private readonly openedBy = new Set<() => void>();

  start(): void {
    this.greet();
    this.live.open();
  }

  /** With the key of a studio that was started anew. */
  restart(): void {
    this.refusal = null;
    this.greet();
    this.live.again();
  }

  send(message: FromPage): boolean {
    return this.live.send(message);
  }

  /** Calls back until the returned function is called. */
  listen(on: { seen: (seen: LookAnswer) => void; tried: (found: CheckAnswer) => void; changed: (path: string) => void; opened: () => void }): () => void {
    this.seenBy.add(on.seen);
    this.triedBy.add(on.tried);
    this.changedBy.add(on.changed);
    this.openedBy.add(on.opened);
    return () => {
      this.seenBy.delete(on.seen);
      this.triedBy.delete(on.tried);
      this.changedBy.delete(on.changed);
      this.openedBy.delete(on.opened);
    };
  }

  private greet(): void {
    void ask<HelloAnswer>('GET', '/api/hello').then(
      (hello) => {
        this.hello = hello;
        this.isRefused = false;
      },
      (error: unknown) => {
        if (error instanceof Refusal && (error.status === 401 || error.status === 403)) this.isRefused = true;
      },
    );
  }

  private connected(connection: Connection): void {
    this.connection = connection;
    if (connection.state === 'lost') this.greet();
  }

  private hear(message: ToPage): void {
    if (message.kind === 'hello') {
      this.jobs = message.jobs;
      this.openedBy.forEach((call) => call());
    } else if (message.kind === 'job') {
      const others = this.jobs.filter((job) => job.id !== message.job.id);
      this.jobs = [...others, message.job];
    } else if (message.kind === 'look_answer') this.seenBy.forEach((call) => call(message));
    else if (message.kind === 'check_answer') this.triedBy.forEach((call) => call(message));
    else if (message.kind === 'changed') this.changedBy.forEach((call) => call(message.path));
    else if (message.kind === 'refused') this.refusal = message.message;
  }
}

export const session = new Session();
