#lang racket/base
;; Exercises as one line of text, for the student's file: compressed, so that the key does not
;; meet the eye.  That is an envelope and no lock: who wants to can open it.  What must not be
;; known is left out, by the clause (no-practice).

(require file/gunzip
         file/gzip
         net/base64
         "exercise.rkt"
         "../error/complain.rkt")

(provide seal unseal)

;; exercises -> string
(define (seal exercises)
  (define in (open-input-string (format "~s" (map practised exercises))))
  (define out (open-output-bytes))
  (deflate in out)
  (bytes->string/latin-1 (base64-encode (get-output-bytes out) #"")))

;; string -> exercises
(define (unseal text)
  (define (broken . _)
    (complain 'check-answers "the last lines of this worksheet were changed; take a new copy"))
  (with-handlers ([exn:fail? broken])
    (define out (open-output-bytes))
    (inflate (open-input-bytes (base64-decode (string->bytes/latin-1 text))) out)
    (read (open-input-bytes (get-output-bytes out)))))

;; Without what only the teacher has.
(define (practised e)
  (define settings (hash-remove (exercise-settings e) 'check))
  (if (exercise-practice? e)
      (struct-copy exercise e [settings settings])
      (struct-copy exercise e [settings settings] [key #f] [slips '()])))
