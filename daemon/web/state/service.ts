// Services of the daemon, as parts of the page call them.

/** Rejects with an Error if the daemon refuses or the connection is lost. */
export type Call = (service: string, request: unknown) => Promise<unknown>;

/** Why a call failed, in one line. */
export const reason = (error: unknown): string => (error instanceof Error ? error.message : String(error));
