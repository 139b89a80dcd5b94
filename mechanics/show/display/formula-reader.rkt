#lang racket/base
;; Formulas in files that an editor saved, for programs that read such files without editors,
;; as `racket` does when it runs one.

(require "result-formula.rkt"
         racket/class
         wxme)

(provide reader)

(define readable-formula%
  (class* object% (readable<%>)
    (init-field formula)
    (super-new)
    (define/public (read-special source line column position)
      (formula-syntax formula (list source line column position 1)))))

(define reader
  (new (class* object% (snip-reader<%>)
         (super-new)
         (define/public (read-header version stream) (void))
         (define/public (read-snip text-only? version stream)
           (define f (bytes->formula (send stream read-raw-bytes 'formula)))
           (define program (if f (formula-program f) "."))
           (if (and f (not text-only?))
               (new readable-formula% [formula f])
               (string->bytes/utf-8 program))))))
