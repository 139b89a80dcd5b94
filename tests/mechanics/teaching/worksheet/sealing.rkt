#lang racket/base
;; The envelope of a student's file: what is put into it comes out of it, and what anybody else
;; puts there does no harm.

(require file/gzip
         mechanics/teaching/worksheet/make-exercise
         mechanics/teaching/worksheet/read-untrusted
         mechanics/teaching/worksheet/sealed-exercises
         net/base64
         "../../support/checks.rkt")

(define e
  (make-exercise 'frequency 'expression "How fast, at #e1e99 or #x10?"
                 '((key k) (within 1/1000) (hint "look" #:after 2) (slip m "no" #:credit 1/2))))

(test-case "what is sealed comes back"
  (check-equal? (unseal (seal (list e))) (list e))
  (check-equal? (unseal (seal '())) '()))

(define (envelope bytes)
  (define out (open-output-bytes))
  (deflate (open-input-bytes bytes) out)
  (bytes->string/latin-1 (base64-encode (get-output-bytes out) #"")))

(define (check-refused bytes)
  (check-exn #rx"worksheet: the lines that hold its exercises were changed"
             (lambda () (unseal (envelope bytes)))
             (format "~s" (subbytes bytes 0 (min 40 (bytes-length bytes))))))

(test-case "what was put there by others is refused"
  (for ([b (in-list (list #"" #"5" #"(" #"(1 2)" #"#&(1)" #"#0=(1 . #0#)" #"#reader racket/base ()"
                          #"#lang racket/base" #"#~CS" #"\377\376"))])
    (check-refused b)))

(test-case "no number takes forever to be made"
  (for ([b (in-list (list #"(#e1e999999999)" #"(#d#e1e999999999)" #"(#E1e999999999)"))])
    (check-refused b))
  (check-refused (make-bytes 3000000 (char->integer #\1)))
  (define (number-of digits) (read-untrusted (make-string digits #\9)))
  (check-equal? (number-of 1999) (- (expt 10 1999) 1))
  (check-exn #rx"more digits than any answer needs" (lambda () (number-of 2000))))

(test-case "no vector is longer than what is written of it"
  (for ([b (in-list (list #"(#99999999999(0))" #"(#fl99999999999(0.0))" #"(#fx99999999999(7))"
                          #"(#F9(0.0))"))])
    (check-refused b))
  (check-equal? (read-untrusted "(#f #false #F #t \"#9(0)\" #(1 2))")
                '(#f #f #f #t "#9(0)" #(1 2))))

(test-case "no envelope holds more than a worksheet would"
  (define (empty-list-and-spaces n) (bytes-append #"()" (make-bytes n (char->integer #\space))))
  (check-equal? (unseal (envelope (empty-list-and-spaces 3999998))) '())
  (check-refused (empty-list-and-spaces 3999999)))
