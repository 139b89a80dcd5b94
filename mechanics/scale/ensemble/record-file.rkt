#lang racket/base
;; Records in a file, each with a checksum, so that one that was damaged on the disk is told from
;; a good one, and the good ones after it are found.
;;
;; A record is a mark, its length, the least byte first, so many bytes, and the SHA-1 of length and
;; bytes.  Where there is none that is whole, the next mark is looked for behind which there is one:
;; bytes between are damaged.  Those behind the last good one were cut off while they were written,
;; or are damaged.

(require racket/fasl)

(provide record-bytes read-record read-records)

(define mark #"\nrecord\n")
(define checksum-length 20)

;; x -> the bytes of its record
(define (record-bytes x)
  (define content (s-exp->fasl x))
  (define body (bytes-append (integer->integer-bytes (bytes-length content) 8 #f #f) content))
  (bytes-append mark body (sha1-bytes body)))

;; size : of the file
;; -> the value of the record at that place, #f; or if there is none that is good, #f and whether
;; there is a whole one, with a wrong checksum
(define (read-record in place size)
  (define (next n)
    (define bytes (and (<= n (- size (file-position in))) (read-bytes n in)))
    (and (bytes? bytes) (= n (bytes-length bytes)) bytes))
  (file-position in (min place size))
  (define here? (equal? (next (bytes-length mark)) mark))
  (define head (and here? (next 8)))
  (define content (and head (next (integer-bytes->integer head #f #f))))
  (define checksum (and content (next checksum-length)))
  (cond [(not checksum) (values #f #f)]
        [(equal? checksum (sha1-bytes (bytes-append head content)))
         (values (fasl->s-exp content) #f)]
        [else (values #f #t)]))

;; From a place on, (add! value) for each that is good
;; -> the place behind the last, and how many places before the end are damaged
(define (read-records in place size add!)
  (let loop ([place place] [damaged 0])
    (define-values (value wrong?) (read-record in place size))
    (cond [value
           (add! value)
           (loop (file-position in) damaged)]
          [else
           (define next (next-good in place size))
           (cond [next (loop next (add1 damaged))]
                 [else (values place (if wrong? (add1 damaged) damaged))])])))

;; -> the place of the next good record behind one, or #f
(define (next-good in place size)
  (file-position in (min size (add1 place)))
  (define found (regexp-match-positions (byte-regexp (regexp-quote mark)) in))
  (and found
       (let ([next (+ place 1 (caar found))])
         (define-values (value _) (read-record in next size))
         (if value next (next-good in next size)))))
