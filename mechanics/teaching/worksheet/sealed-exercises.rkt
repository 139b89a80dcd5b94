#lang racket/base
;; Exercises as one line of text, for the student's file: compressed, so that the key does not
;; meet the eye.  That is an envelope and no lock: anybody can open it.  The clause (no-practice)
;; leaves out a key that must stay unknown.  Anybody may have changed the text before it returns.

(require file/gunzip
         file/gzip
         net/base64
         "exercise.rkt" "read-untrusted.rkt"
         "../../error/complain.rkt")

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
    (complain 'worksheet "the lines that hold its exercises were changed; take a new copy"))
  (with-handlers ([exn:fail? broken])
    (define found (read-untrusted (inflated (base64-decode (string->bytes/latin-1 text)))))
    (unless (and (list? found) (andmap exercise? found)) (broken))
    found))

;; A few bytes may stand for more text than the memory holds.
(define (inflated bytes)
  (define out (open-output-bytes))
  (inflate (open-input-bytes bytes) (bounded out))
  (bytes->string/utf-8 (get-output-bytes out)))

(define most-bytes 4000000)

;; A port that writes to the port out of bytes, and raises an error when it has too many.
(define (bounded out)
  (make-output-port
   'bounded out
   (lambda (bytes from to _buffered? _breakable?)
     (when (> (+ (file-position out) (- to from)) most-bytes)
       (error 'unseal "there are more than ~a bytes" most-bytes))
     (write-bytes bytes out from to))
   void))

;; The exercise without the parts that only the teacher has.
(define (practised e)
  (define safe (struct-copy exercise e [settings (hash-remove (exercise-settings e) 'check)]))
  (if (exercise-practice? e) safe (struct-copy exercise safe [key #f] [slips '()])))
