import { describe, expect, it } from 'vitest';
import { verdict, type Finding, type Severity } from '../../../daemon/web/state/doctor.ts';

const finding = (severity: Severity): Finding => ({ severity, name: 'disk', seen: '', fix: '' });

describe('the verdict of an examination', () => {
  it('counts what was found', () => {
    expect(verdict(['ok', 'warning', 'note', 'note'].map((each) => finding(each as Severity)))).toBe('Ready to drive: 0 errors, 1 warning, 2 notes.');
  });

  it('is that the robot does not drive if there is an error', () => {
    expect(verdict([finding('error')])).toBe('Not ready to drive: 1 error, 0 warnings, 0 notes.');
  });
});
