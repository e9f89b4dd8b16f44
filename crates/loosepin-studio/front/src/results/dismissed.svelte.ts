// Runs that were put away: they are not shown again, on any screen.
import type { Job } from '../messages.ts';

class Dismissed {
  private ids = $state.raw<ReadonlySet<Job['id']>>(new Set());

  has(job: Job): boolean {
    return this.ids.has(job.id);
  }

  add(job: Job): void {
    this.ids = new Set([...this.ids, job.id]);
  }
}

export const dismissed = new Dismissed();

export function isActive(job: Job): boolean {
  return job.state === 'running' || job.state === 'waiting';
}
